package carom.client.desktop.game;

import carom.sim.event.Sound;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.files.FileHandle;
import com.badlogic.gdx.utils.Disposable;
import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.Map;
import org.lwjgl.openal.ALC10;

/** The machine's loudspeakers, if it has any. Render thread only. */
public final class AudioDevice implements Speaker, Disposable {
  private final Map<Sound, com.badlogic.gdx.audio.Sound> sounds = new EnumMap<>(Sound.class);

  /**
   * Loads the sounds. The toolkit must run.
   *
   * @param wanted whether the toolkit was asked for sound
   */
  public AudioDevice(boolean wanted) {
    if (!wanted || ALC10.alcGetCurrentContext() == 0) {
      return;
    }
    for (Sound sound : Sound.values()) {
      if (sound != Sound.NONE) {
        sounds.put(sound, Gdx.audio.newSound(new Wav(sound)));
      }
    }
  }

  /** A sound in memory, where the toolkit expects a file. */
  private static final class Wav extends FileHandle {
    private final byte[] bytes;

    Wav(Sound sound) {
      super(sound.name() + ".wav");
      bytes = Waves.wav(sound);
    }

    @Override
    public InputStream read() {
      return new ByteArrayInputStream(bytes);
    }

    @Override
    public long length() {
      return bytes.length;
    }
  }

  /**
   * Returns whether it is worth to ask the toolkit for sound; asked first, because on a Linux
   * without a device the system's library answers with a page of errors.
   */
  public static boolean mayExist() {
    if (!System.getProperty("os.name").startsWith("Linux")) {
      return true;
    }
    String run = System.getenv().getOrDefault("XDG_RUNTIME_DIR", "/run/user/none");
    return System.getenv("PULSE_SERVER") != null
        || Files.exists(Path.of(run, "pulse", "native"))
        || Files.exists(Path.of(run, "pipewire-0"))
        || hasCard();
  }

  private static boolean hasCard() {
    try (DirectoryStream<Path> outputs =
        Files.newDirectoryStream(Path.of("/dev/snd"), "pcmC*D*p")) {
      return outputs.iterator().hasNext();
    } catch (java.io.IOException e) {
      return false; // no such folder
    }
  }

  @Override
  public boolean works() {
    return !sounds.isEmpty();
  }

  @Override
  public long play(Sound sound, float volume, float pan, float pitch) {
    return works() ? sounds.get(sound).play(volume, pitch, pan) : -1;
  }

  @Override
  public void stop(Sound sound, long id) {
    if (works()) {
      sounds.get(sound).stop(id);
    }
  }

  @Override
  public void dispose() {
    sounds.values().forEach(com.badlogic.gdx.audio.Sound::dispose);
  }
}
