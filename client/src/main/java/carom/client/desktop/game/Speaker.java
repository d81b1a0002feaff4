package carom.client.desktop.game;

import carom.sim.event.Sound;

/** A device that plays sounds. Render thread only. */
interface Speaker {
  /** Returns whether it can be heard. */
  boolean works();

  /**
   * Starts a sound.
   *
   * @param sound what to play, not {@link Sound#NONE}
   * @param volume 0..1
   * @param pan -1 = left, 0 = ahead, 1 = right
   * @param pitch 1 = as made, 2 = an octave higher and half as long
   * @return names it for {@link #stop}
   */
  long play(Sound sound, float volume, float pan, float pitch);

  /** Stops a sound that was started; does nothing if it is over. */
  void stop(Sound sound, long id);
}
