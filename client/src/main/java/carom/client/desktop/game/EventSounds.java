package carom.client.desktop.game;

import carom.client.EventListener;
import carom.client.look.Effect;
import carom.client.look.LookFiles;
import carom.client.look.SoundFile;
import carom.sim.event.EventKind;
import carom.sim.event.Sound;
import carom.sim.outbox.Event;
import carom.text.FileErrors;
import com.badlogic.gdx.math.MathUtils;
import java.io.IOException;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Plays the sounds of events and of a game's look, louder if they are hard and near, and from the
 * side they come from. Of many events at the same time the loudest are heard. Render thread only;
 * no allocation per event.
 */
public final class EventSounds implements EventListener, HeardEffects {
  /** Most sounds at a time. */
  static final int VOICES = 10;

  /** Least time between two equal sounds, seconds: a pile-up isn't louder than a blow. */
  private static final float APART_SECONDS = 0.045f;

  /** Least loudness that is played, 0..1. */
  private static final float FAINTEST = 0.03f;

  /** Distance at which a sound is half as loud, metres; sounds of large events carry farther. */
  private static final float NEAR_M = 9;

  /** Distance to the side at which a sound comes from that side only, metres. */
  private static final float ASIDE_M = 18;

  private static final float MOST_ASIDE = 0.8f;

  /** Loudness of the softest event, 0..1. */
  private static final float SOFTEST = 0.08f;

  /** Loudness of music beside the loudest sound. */
  private static final float MUSIC = 0.5f;

  /** Largest files, bytes. */
  private static final int MAX_SOUND = 4 << 20;

  private static final int MAX_MUSIC = 24 << 20;
  private static final Logger LOG = LoggerFactory.getLogger(EventSounds.class);

  /** A sound that is playing. */
  private static final class Voice {
    final Event event = new Event();
    Clip clip;
    boolean ofEvent;
    float loudness;
    double until;
    long id;
  }

  private final Speaker speaker;
  private final Voice[] voices = new Voice[VOICES];
  private final Map<String, Clip> files = new HashMap<>();
  private final Set<String> unplayable = new HashSet<>();
  private ShownLook look;
  private float volume;
  private boolean muted;

  /** Time, seconds; a float would stand still after some days. */
  private double now;

  private float listenerX;
  private float listenerY;

  /**
   * Creates a player of sounds.
   *
   * @param volume of the loudest sound, 0..1
   */
  public EventSounds(Speaker speaker, float volume) {
    this.speaker = speaker;
    this.volume = volume;
    for (int i = 0; i < VOICES; i++) {
      voices[i] = new Voice();
    }
  }

  /** Sets the volume of the loudest sound, 0..1; sounds that play keep theirs. */
  public void volume(float loudest) {
    volume = loudest;
    tellMusic();
  }

  private void tellMusic() {
    speaker.musicVolume(muted ? 0 : MUSIC * volume);
  }

  /** Plays the sounds and the music of a game's look from now on; null for the usual sounds. */
  public void look(ShownLook of) {
    for (Voice voice : voices) {
      stop(voice);
    }
    files.values().forEach(Clip::dispose);
    files.clear();
    unplayable.clear();
    look = of;
    if (of != null && speaker.works()) {
      of.setup().effects().forEach(this::read); // now, not as the first shot is heard
    }
    String file = of == null ? "" : of.setup().music();
    try {
      byte[] bytes =
          file.isEmpty() || !speaker.works() ? null : LookFiles.read(of.home(), file, MAX_MUSIC);
      speaker.music(file, bytes);
    } catch (IOException e) {
      missing(file, e);
    }
    tellMusic();
  }

  private void missing(String file, IOException e) {
    LOG.error("the sound {} of {} can't be used: {}", file, look.home(), FileErrors.reason(e));
    look.tell("A sound of the game's look can't be played: " + file);
  }

  /** Reads the files of an effect that is a sound. One that can't be played is told once. */
  private void read(Effect effect) {
    if (!(effect instanceof SoundFile sound)) {
      return;
    }
    for (String file : sound.files()) {
      try {
        if (!files.containsKey(file) && !unplayable.contains(file)) {
          files.put(file, speaker.clip(file, LookFiles.read(look.home(), file, MAX_SOUND)));
        }
      } catch (IOException e) {
        unplayable.add(file);
        missing(file, e);
      }
    }
  }

  /** Switches the sound off or on; playing sounds stop. */
  public void mute(boolean silent) {
    muted = silent;
    tellMusic();
    for (Voice voice : voices) {
      if (silent) {
        stop(voice);
      }
    }
  }

  /** Returns whether the player has switched the sound off. */
  public boolean muted() {
    return muted;
  }

  /** Returns whether anything could be heard. */
  public boolean audible() {
    return speaker.works() && volume > 0;
  }

  /** Lets time pass and sets where the listener is, metres; call it once per frame. */
  public void listen(float x, float y, float seconds) {
    now += seconds;
    listenerX = x;
    listenerY = y;
  }

  @Override
  public void happened(Event event, boolean predicted) {
    if (muted || !audible()) {
      return;
    }
    float hardness = hardness(event);
    float nearness = nearness(event.x(), event.y(), event.kind().radius());
    List<Effect> effects = look == null ? null : look.setup().event(event.kind().name());
    boolean own = false;
    for (int i = 0; effects != null && i < effects.size(); i++) {
      if (effects.get(i) instanceof SoundFile file) {
        own |= play(file, event, event.x(), hardness, nearness);
      }
    }
    Sound sound = event.kind().sound();
    if (!own && sound != Sound.NONE) {
      float pitch = 1.1f - 0.2f * hardness; // what is hit harder sounds larger
      play(speaker.clip(sound), event, event.x(), Math.max(SOFTEST, hardness) * nearness, pitch);
    }
  }

  @Override
  public void play(SoundFile file, float x, float y, float hardness) {
    if (!muted && audible()) {
      play(file, null, x, hardness, nearness(x, y, 0));
    }
  }

  /** Plays the sound of a file, if it is loud enough; returns false if there is none. */
  private boolean play(SoundFile file, Event event, float x, float hardness, float nearness) {
    List<String> names = file.files();
    Clip clip = files.get(names.get(MathUtils.random(names.size() - 1)));
    if (clip == null) {
      return false;
    }
    float loudness = file.volume() * Math.max(SOFTEST, hardness) * nearness;
    play(clip, event, x, loudness, file.pitch(MathUtils.random()));
    return true;
  }

  private void play(Clip clip, Event event, float x, float loudness, float pitch) {
    boolean echo = now < clip.quietUntil && loudness <= clip.lastLoudness;
    Voice voice = quietest();
    if (loudness < FAINTEST || echo || (playing(voice) && voice.loudness >= loudness)) {
      return;
    }
    stop(voice);
    clip.quietUntil = now + APART_SECONDS;
    clip.lastLoudness = loudness;
    float aside = MathUtils.clamp((x - listenerX) / ASIDE_M, -MOST_ASIDE, MOST_ASIDE);
    voice.ofEvent = event != null;
    if (event != null) {
      voice.event.set(event);
    }
    voice.clip = clip;
    voice.loudness = loudness;
    voice.until = now + clip.seconds() / pitch;
    voice.id = clip.play(volume * loudness, aside, pitch);
  }

  /** Stops the sound of an event that did not happen. */
  @Override
  public void retracted(Event event) {
    for (Voice voice : voices) {
      boolean isIts = voice.ofEvent && voice.event.tick() == event.tick();
      if (playing(voice) && isIts && voice.event.isLike(event)) {
        stop(voice);
      }
    }
  }

  private static float hardness(Event event) {
    EventKind kind = event.kind();
    return kind.fullStrength() == 0
        ? 1
        : MathUtils.clamp(event.strength() / kind.fullStrength(), 0, 1);
  }

  private float nearness(float x, float y, float radius) {
    float near = NEAR_M + 2 * radius;
    float dx = x - listenerX;
    float dy = y - listenerY;
    return 1 / (1 + (dx * dx + dy * dy) / (near * near));
  }

  /** Returns a free voice or, without one, the quietest. */
  private Voice quietest() {
    Voice found = voices[0];
    for (Voice voice : voices) {
      if (!playing(voice)) {
        return voice;
      }
      found = voice.loudness < found.loudness ? voice : found;
    }
    return found;
  }

  private boolean playing(Voice voice) {
    return now < voice.until;
  }

  private void stop(Voice voice) {
    if (playing(voice)) {
      voice.until = now;
      voice.clip.stop(voice.id);
    }
  }
}
