package carom.client.look;

import carom.physics.math.Limits;
import java.util.ArrayList;
import java.util.List;

/**
 * A sound from a file of the game's jar, louder the harder and nearer its cause is. With several
 * files, a random one is heard. Each method changes it and returns it.
 *
 * <pre>{@code
 * v.event("shot", SoundFile.of("shot1.ogg", "shot2.ogg").volume(0.7f).pitch(0.9f, 1.1f));
 * }</pre>
 */
public final class SoundFile implements Effect {
  private final List<String> files;
  private float volume = 1;
  private float leastPitch = 0.95f;
  private float mostPitch = 1.05f;

  private SoundFile(List<String> files) {
    this.files = files;
  }

  /**
   * Returns the sound of one of some files: {@code .wav} (16 bits) or {@code .ogg}, found as
   * sprites' files are.
   */
  public static SoundFile of(String first, String... more) {
    List<String> all = new ArrayList<>(Range.all("sound", more));
    all.add(0, first);
    for (String file : all) {
      requireSound(file);
    }
    return new SoundFile(List.copyOf(all));
  }

  /** Throws for a file that is no sound by its name. */
  static void requireSound(String file) {
    if (!Limits.notNull("sound", file).endsWith(".wav") && !file.endsWith(".ogg")) {
      throw new IllegalArgumentException(
          "sound=\"" + file + "\" is neither .wav nor .ogg; convert it to one of them");
    }
  }

  /** Sets its loudness, 0..1; 1 without it. */
  public SoundFile volume(float share) {
    volume = Range.check("a sound's volume", share, 0, 1);
    return this;
  }

  /** Sets the range of its pitch, 0.5..2, where 1 is as recorded; 0.95..1.05 without it. */
  public SoundFile pitch(float least, float most) {
    Range.checkPair("pitch", least, most, 0.5f, 2);
    leastPitch = least;
    mostPitch = most;
    return this;
  }

  /** Returns the names of its files. */
  public List<String> files() {
    return files;
  }

  /** Returns its loudness, 0..1. */
  public float volume() {
    return volume;
  }

  /** Returns the pitch for a random number of 0..1. */
  public float pitch(float random) {
    return leastPitch + (mostPitch - leastPitch) * random;
  }
}
