package carom.client.desktop.game;

import carom.sim.event.Sound;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.audio.Music;
import com.badlogic.gdx.backends.lwjgl3.audio.OpenALSound;
import com.badlogic.gdx.files.FileHandle;
import com.badlogic.gdx.utils.Disposable;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.Map;
import org.lwjgl.openal.ALC10;

/** The machine's loudspeakers, if it has any. Render thread only. */
public final class AudioDevice implements Speaker, Disposable {
  private final Map<Sound, Clip> sounds = new EnumMap<>(Sound.class);
  private Music music;
  private float musicVolume;

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
        sounds.put(sound, load(sound.name() + ".wav", Waves.wav(sound)));
      }
    }
  }

  /** A file in memory, where the toolkit expects one on a disk. */
  private static final class InMemory extends FileHandle {
    private final byte[] bytes;

    InMemory(String name, byte[] bytes) {
      super(name);
      this.bytes = bytes;
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

  /** A sound of the toolkit. */
  private static final class Loaded extends Clip {
    private final com.badlogic.gdx.audio.Sound sound;
    private final float seconds;

    Loaded(com.badlogic.gdx.audio.Sound sound) {
      this.sound = sound;
      seconds = ((OpenALSound) sound).duration();
    }

    @Override
    float seconds() {
      return seconds;
    }

    @Override
    long play(float volume, float pan, float pitch) {
      return sound.play(volume, pitch, pan);
    }

    @Override
    void stop(long id) {
      sound.stop(id);
    }

    @Override
    void dispose() {
      sound.dispose();
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
    } catch (IOException e) {
      return false; // no such folder
    }
  }

  @Override
  public boolean works() {
    return !sounds.isEmpty();
  }

  private static Clip load(String name, byte[] bytes) {
    return new Loaded(Gdx.audio.newSound(new InMemory(name, bytes)));
  }

  @Override
  public Clip clip(Sound sound) {
    return sounds.get(sound);
  }

  @Override
  public Clip clip(String name, byte[] bytes) throws IOException {
    try {
      return load(name, bytes);
    } catch (RuntimeException e) { // the decoders throw all kinds
      throw new IOException(name + " can't be decoded: " + e, e);
    }
  }

  @Override
  public void music(String name, byte[] bytes) throws IOException {
    if (music != null) {
      music.dispose();
      music = null;
    }
    if (bytes == null || !works()) {
      return;
    }
    try {
      music = Gdx.audio.newMusic(new InMemory(name, bytes));
      music.setLooping(true);
      musicVolume(musicVolume);
    } catch (RuntimeException e) { // as above
      music = null;
      throw new IOException(name + " can't be decoded: " + e, e);
    }
  }

  @Override
  public void musicVolume(float volume) {
    musicVolume = volume;
    if (music == null) {
      return;
    }
    music.setVolume(volume);
    if (volume == 0) {
      music.pause();
    } else if (!music.isPlaying()) {
      music.play();
    }
  }

  @Override
  public void dispose() {
    if (music != null) {
      music.dispose();
    }
    sounds.values().forEach(Clip::dispose);
  }
}
