package carom.client.desktop.game;

import carom.sim.event.Sound;
import java.io.IOException;

/** A device that plays sounds. Render thread only. */
interface Speaker {
  /** Returns whether it can be heard. */
  boolean works();

  /** Returns one of the usual sounds, not {@link Sound#NONE}; the same for ever. */
  Clip clip(Sound sound);

  /**
   * Reads the sound of a file. The caller disposes it.
   *
   * @param name with the ending that says how it is encoded
   * @throws IOException if it can't be decoded
   */
  Clip clip(String name, byte[] bytes) throws IOException;

  /**
   * Plays music on and on, in place of what it played before; null for silence.
   *
   * @throws IOException if it can't be decoded
   */
  void music(String name, byte[] bytes) throws IOException;

  /** Sets the volume of the music, 0..1; at 0 it pauses. */
  void musicVolume(float volume);
}
