package carom.client.desktop.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.look.Reaction;
import org.junit.jupiter.api.Test;

/** Goal: a struck body shows its blow and is itself again. Method: time passes by hand. */
final class ReactionsTest {
  private final Reactions.Shown shown = new Reactions.Shown();

  @Test
  void aBodyIsSqueezedByTheBlowsShareSpringsAndIsItself() {
    shown.begin(new Reaction().squash(0.4f).seconds(0.5f), 0, 0, 1, 0, 0.5f);
    assertEquals(0.2f, shown.squash(), 1e-6f);
    float least = 1;
    for (int i = 0; i < 60; i++) {
      shown.age(0.5f / 60);
      least = Math.min(least, shown.squash());
      assertTrue(Math.abs(shown.squash()) <= 0.2f);
    }
    assertTrue(least < -0.01f, "it springs: " + least);
    shown.age(0.01f);
    assertEquals(0, shown.squash());
    assertEquals(0, shown.flash());
  }

  @Test
  void aBodyIsHeldThenCatchesUpAndNeverIsFarFromItsPlace() {
    shown.begin(new Reaction().hold(0.1f), 5, 1, 0, 0, 1);
    assertEquals(0, shown.normalX());
    assertEquals(1, shown.normalY(), "without a direction it is squeezed from above");
    shown.age(0.1f);
    assertEquals(-1.5f, shown.moveX(6.5f), 1e-6f, "it is where it was struck");
    assertEquals(-2, shown.moveX(90), 1e-6f);
    shown.age(0.05f);
    assertEquals(-0.75f, shown.moveX(6.5f), 1e-5f, "half way");
    shown.age(0.06f);
    assertEquals(0, shown.moveX(6.5f), 1e-9f);
    assertEquals(0, shown.moveY(9), 1e-9f);
  }

  @Test
  void aBodyIsLitUpInTheColourThatFades() {
    shown.begin(new Reaction().flash(0xff123456).seconds(0.4f), 0, 0, 0, 1, 1);
    assertEquals(1, shown.flash());
    assertEquals(0x123456, shown.flashRgb());
    shown.age(0.3f);
    assertEquals(0.25f, shown.flash(), 1e-6f);
    shown.begin(new Reaction().squash(0.1f), 0, 0, 0, 1, 1);
    assertEquals(0, shown.flash(), "another reaction takes its place");
  }

  @Test
  void whatCanNotBeMeantIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> new Reaction().squash(0.91f));
    assertThrows(IllegalArgumentException.class, () -> new Reaction().hold(0.31f));
    assertThrows(IllegalArgumentException.class, () -> new Reaction().seconds(Float.NaN));
  }
}
