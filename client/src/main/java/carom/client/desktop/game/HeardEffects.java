package carom.client.desktop.game;

import carom.client.look.SoundFile;

/** Plays sounds of a game's look that no event has set off. Render thread only. */
@FunctionalInterface
interface HeardEffects {
  /**
   * Plays a sound.
   *
   * @param x where, metres
   * @param y where, metres
   * @param hardness of its cause, 0..1
   */
  void play(SoundFile file, float x, float y, float hardness);
}
