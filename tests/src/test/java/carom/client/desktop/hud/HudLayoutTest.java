package carom.client.desktop.hud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.desktop.hud.HudLayout.Panel;
import carom.client.desktop.hud.HudLayout.Spot;
import org.junit.jupiter.api.Test;

/** Goal: parts of the HUD cover neither each other nor the own body. Method: a body on its way. */
final class HudLayoutTest {
  private final HudLayout layout = new HudLayout();

  @Test
  void partsCoverNeitherTheOwnBodyNorEachOther() {
    float[][] windows = {{1_280, 720}, {853, 480}, {1_024, 576}};
    for (float[] window : windows) {
      Panel[] parts = {
        new Panel(Spot.TOP),
        new Panel(Spot.TOP_RIGHT, Spot.TOP_LEFT, Spot.BOTTOM_RIGHT),
        new Panel(Spot.BOTTOM_LEFT, Spot.BOTTOM_RIGHT, Spot.TOP_LEFT),
        new Panel(Spot.TOP_LEFT, Spot.BOTTOM_RIGHT, Spot.BOTTOM_LEFT, Spot.TOP_RIGHT),
        new Panel(Spot.BOTTOM_RIGHT, Spot.BOTTOM_LEFT, Spot.TOP_LEFT)
      };
      float[][] sizes = {{180, 30}, {190, 142}, {460, 90}, {226, 88}, {250, 240}};
      boolean[] stood = new boolean[parts.length];
      for (int step = 0; step < 20_000; step++) {
        float x = window[0] * (0.5f + 0.5f * (float) Math.sin(step * 0.0137));
        float y = window[1] * (0.5f + 0.5f * (float) Math.sin(step * 0.0071));
        layout.begin(window[0], window[1]);
        layout.keepFree(x, y, 12);
        FreePlaces taken = new FreePlaces();
        for (int i = 0; i < parts.length; i++) {
          if (!layout.place(parts[i], sizes[i][0], sizes[i][1])) {
            continue;
          }
          stood[i] = true;
          float left = parts[i].x();
          float bottom = parts[i].y();
          String what = "panel " + i + " window=" + window[0] + " x=" + x + " y=" + y;
          assertTrue(left >= 0 && bottom >= 0, what);
          assertTrue(left + sizes[i][0] <= window[0] && bottom + sizes[i][1] <= window[1], what);
          assertTrue(taken.isFree(left, bottom, sizes[i][0], sizes[i][1]), what);
          boolean aside = x + 12 < left || x - 12 > left + sizes[i][0];
          assertTrue(aside || y + 12 < bottom || y - 12 > bottom + sizes[i][1], what);
          taken.take(left, bottom, sizes[i][0], sizes[i][1]);
        }
      }
      for (int i = 0; i < parts.length; i++) {
        assertTrue(stood[i], "panel " + i + " has a place in a window of " + window[0]);
      }
    }
  }

  @Test
  void aPartStaysWhileThePlayerIsElsewhere() {
    Panel panel = new Panel(Spot.TOP_LEFT, Spot.BOTTOM_RIGHT);
    assertEquals(8, at(panel, 640, 360));
    assertEquals(1_280 - 226 - 8, at(panel, 100, 700), "the player is in its corner");
    assertEquals(1_280 - 226 - 8, at(panel, 640, 360), "it doesn't go back by itself");
    assertEquals(8, at(panel, 1_200, 30));
  }

  @Test
  void withoutRoomAPartIsntDrawnUnlessItMustBe() {
    layout.begin(300, 200);
    layout.keepFree(150, 100, 12);
    Panel large = new Panel(Spot.TOP_LEFT);
    assertFalse(layout.place(large, 280, 180));
    assertTrue(layout.placeAnyhow(large, 280, 180));
    assertFalse(layout.placeAnyhow(new Panel(Spot.TOP_LEFT), 400, 180), "wider than the window");
  }

  private float at(Panel panel, float x, float y) {
    layout.begin(1_280, 720);
    layout.keepFree(x, y, 12);
    assertTrue(layout.place(panel, 226, 88));
    return panel.x();
  }
}
