package carom.client.desktop.game;

/** Something that a {@link Speaker} plays. Render thread only. */
abstract class Clip {
  /** Time until which an equal and softer sound would be an echo, seconds. */
  double quietUntil;

  /** Loudness of the last one. */
  float lastLoudness;

  /** Returns its length at its own pitch, seconds. */
  abstract float seconds();

  /**
   * Starts it.
   *
   * @param volume 0..1
   * @param pan -1 = left, 0 = ahead, 1 = right
   * @param pitch 1 = as made, 2 = an octave higher and half as long
   * @return names it for {@link #stop}
   */
  abstract long play(float volume, float pan, float pitch);

  /** Stops what was started; does nothing if it is over. */
  abstract void stop(long id);

  /** Frees what it holds; for a file's. */
  void dispose() {}
}
