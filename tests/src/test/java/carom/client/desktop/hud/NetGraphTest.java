package carom.client.desktop.hud;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Goal: the net graph never covers the own player. Method: a player who walks everywhere. */
class NetGraphTest {
  private static final float EDGE = 10;

  @Test
  void thePanelIsNeverWhereThePlayerIs() {
    float[][] windows = {{1_280, 720}, {853, 480}, {640, 360}};
    float[][] panels = {{226, 88}, {330, 376}};
    for (float[] window : windows) {
      for (float[] panel : panels) {
        boolean twoCornersFit = 2 * panel[1] + 200 < window[1] || 2 * panel[0] + 200 < window[0];
        boolean atBottomRight = false;
        for (int step = 0; step < 20_000; step++) {
          float x = window[0] * (0.5f + 0.5f * (float) Math.sin(step * 0.0137));
          float y = window[1] * (0.5f + 0.5f * (float) Math.sin(step * 0.0071));
          atBottomRight =
              NetGraph.isAtBottomRight(
                  atBottomRight, x, y, window[0], window[1], panel[0], panel[1]);
          float left = atBottomRight ? window[0] - EDGE - panel[0] : EDGE;
          float bottom = atBottomRight ? EDGE : window[1] - EDGE - panel[1];
          boolean covered = x > left && x < left + panel[0] && y > bottom && y < bottom + panel[1];
          assertFalse(covered && twoCornersFit, "window=" + window[0] + " x=" + x + " y=" + y);
        }
      }
    }
  }

  @Test
  void thePanelStaysWhileThePlayerIsElsewhere() {
    assertFalse(NetGraph.isAtBottomRight(false, 640, 360, 1_280, 720, 226, 88));
    assertTrue(NetGraph.isAtBottomRight(true, 640, 360, 1_280, 720, 226, 88));
    assertTrue(NetGraph.isAtBottomRight(false, 100, 700, 1_280, 720, 226, 88));
    assertFalse(NetGraph.isAtBottomRight(true, 1_200, 30, 1_280, 720, 226, 88));
  }
}
