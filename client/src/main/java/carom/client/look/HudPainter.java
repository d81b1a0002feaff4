package carom.client.look;

import carom.client.view.ClientView;

/**
 * Draws what no line of the HUD shows, over each picture of the window: a speedometer, a compass, a
 * card. If it throws, it is left out for the rest of the level, and the player is told once.
 */
@FunctionalInterface
public interface HudPainter {
  /** Draws over a picture, on the thread that draws. Keep neither argument. */
  void paint(HudCanvas canvas, ClientView view);
}
