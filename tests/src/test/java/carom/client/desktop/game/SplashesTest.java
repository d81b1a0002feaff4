package carom.client.desktop.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.spawn.Origin;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: a body that hits water throws drops, once. Method: a lake below 0, frame by frame. */
final class SplashesTest {
  private static final float FRAME = 1 / 60f;
  private static final int BLUE = 0x3a86c8;

  private final Splashes splashes = new Splashes();
  private final Splashes.WaterMap lake = (x, y) -> y < 0 ? BLUE : Splashes.NONE;
  private float y = 3;

  private void frames(int count, float vy) {
    for (int i = 0; i < count; i++) {
      splashes.age(lake, 0, -10, FRAME);
      y += vy * FRAME;
      splashes.watch(lake, 7, 1, 0.5f, 1, y, 0, vy);
    }
  }

  @Test
  void aBodyThatFallsInSplashesOnceAndTheDropsFallBack() {
    frames(20, -7);
    assertEquals(0, splashes.showing(), "above the water");
    frames(10, -7);
    int drops = splashes.showing();
    assertTrue(drops > 10, "drops=" + drops);
    frames(10, -1);
    assertTrue(splashes.showing() <= drops, "it splashes once");
    frames(90, 0);
    assertEquals(0, splashes.showing());
  }

  @Test
  void aBodyThatFloatsOrSlipsInSplashesNot() {
    y = 0.3f;
    for (int i = 0; i < 60; i++) {
      frames(3, i % 2 == 0 ? -2 : 2);
    }
    assertEquals(0, splashes.showing());
  }

  @Test
  void aBodyThatIsSeenFirstInTheWaterSplashesNot() {
    y = -1;
    frames(30, -9);
    assertEquals(0, splashes.showing());
  }

  @Test
  void theFasterAndLargerTheMoreDrops() {
    Splashes hard = new Splashes();
    hard.age(lake, 0, -10, FRAME);
    hard.watch(lake, 7, 1, 1.5f, 1, 5, 0, -20);
    hard.watch(lake, 7, 1, 1.5f, 1, 0.5f, 0, -20);
    splashes.age(lake, 0, -10, FRAME);
    splashes.watch(lake, 7, 1, 0.3f, 1, 5, 0, -4);
    splashes.watch(lake, 7, 1, 0.3f, 1, 0.1f, 0, -4);
    assertTrue(
        hard.showing() > 2 * splashes.showing(), hard.showing() + " and " + splashes.showing());
  }

  @Test
  void effectsTakeEntitiesWithAnyId() {
    List<Integer> ids = new ArrayList<>(List.of(0, 65_535, Integer.MAX_VALUE));
    ids.add(Origin.FIRST);
    ids.add(Origin.LAST);
    ids.add(Origin.passing(Origin.of(7, 3)));
    Splashes splashes = new Splashes();
    Splashes.WaterMap lake = (x, y) -> y < 0 ? 0x3a86c8 : Splashes.NONE;
    for (int id : ids) {
      splashes.clear();
      for (int i = 0; i < 60; i++) {
        splashes.age(lake, 0, -10, 1 / 60f);
        splashes.watch(lake, id, 1, 0.5f, 1, 3 - i * 0.12f, 0, -7);
      }
      assertTrue(splashes.showing() > 0, "id=" + id);
    }
  }
}
