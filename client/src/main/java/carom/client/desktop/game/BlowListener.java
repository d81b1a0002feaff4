package carom.client.desktop.game;

import carom.sim.level.Archetype;

/** Hears of blows that bodies in the picture get. Render thread only. */
@FunctionalInterface
interface BlowListener {
  /**
   * Hears of a blow.
   *
   * @param body the id of the body in the picture
   * @param kind the body's archetype
   * @param x where, metres
   * @param y where, metres
   * @param normalX unit vector along which the body was pushed
   * @param normalY unit vector along which the body was pushed
   * @param blow change of its velocity, m/s
   * @return whether sparks of the listener's own take the place of the usual ones
   */
  boolean blow(
      int body, Archetype kind, float x, float y, float normalX, float normalY, float blow);
}
