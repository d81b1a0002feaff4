package carom.client.desktop;

import carom.client.events.EventListener;
import carom.sim.Event;
import carom.sim.event.EventKind;
import carom.sim.event.Sound;
import com.badlogic.gdx.math.MathUtils;

/**
 * What events sound like: as loud as they are hard and near, from the side they come from. Each is
 * heard as often as it is told, which is once; of many at the same time the loudest. Render thread
 * only; no allocation per event.
 */
final class EventSounds implements EventListener {
  /** Sounds at a time. */
  static final int VOICES = 10;

  /** Two of a kind are at least this far apart, seconds: a pile-up isn't louder than a blow. */
  private static final float APART_SECONDS = 0.045f;

  /** Fainter ones aren't played, of 1. */
  private static final float FAINTEST = 0.03f;

  /** At this distance a sound is half as loud, metres; what flashes far is heard farther. */
  private static final float NEAR_M = 9;

  /** From here on to the side a sound comes only from there, metres. */
  private static final float ASIDE_M = 18;

  private static final float MOST_ASIDE = 0.8f;

  /** The least of what can be harder or softer is this loud, of 1. */
  private static final float SOFTEST = 0.08f;

  /** A sound that is playing. */
  private static final class Voice {
    final Event event = new Event();
    float loudness;
    double until;
    long id;
  }

  private final Speaker speaker;
  private final Voice[] voices = new Voice[VOICES];
  private final double[] quietUntil = new double[Sound.values().length];
  private final float[] lastLoudness = new float[Sound.values().length];
  private final float volume;
  private boolean muted;

  /** Seconds; a float would stand still after some days. */
  private double now;

  private float earX;
  private float earY;

  /**
   * Creates one.
   *
   * @param volume of the loudest sound, 0..1
   */
  EventSounds(Speaker speaker, float volume) {
    this.speaker = speaker;
    this.volume = volume;
    for (int i = 0; i < VOICES; i++) {
      voices[i] = new Voice();
    }
  }

  /** Silences it, or not; what is playing stops. */
  void mute(boolean silent) {
    muted = silent;
    for (Voice voice : voices) {
      if (silent) {
        stop(voice);
      }
    }
  }

  boolean muted() {
    return muted;
  }

  /** Whether anything could be heard. */
  boolean audible() {
    return speaker.works() && volume > 0;
  }

  /** Lets time pass; sounds are heard at a place, metres. Once per frame. */
  void listen(float x, float y, float seconds) {
    now += seconds;
    earX = x;
    earY = y;
  }

  @Override
  public void happened(Event event, boolean foreseen) {
    Sound sound = event.kind().sound();
    if (muted || sound == Sound.NONE || !audible()) {
      return;
    }
    float hardness = hardness(event);
    float loudness = Math.max(SOFTEST, hardness) * nearness(event);
    boolean echo = now < quietUntil[sound.ordinal()] && loudness <= lastLoudness[sound.ordinal()];
    Voice voice = quietest();
    if (loudness < FAINTEST || echo || (playing(voice) && voice.loudness >= loudness)) {
      return;
    }
    stop(voice);
    quietUntil[sound.ordinal()] = now + APART_SECONDS;
    lastLoudness[sound.ordinal()] = loudness;
    float pitch = 1.1f - 0.2f * hardness; // what is hit harder sounds larger
    float aside = MathUtils.clamp((event.x() - earX) / ASIDE_M, -MOST_ASIDE, MOST_ASIDE);
    voice.event.set(event);
    voice.loudness = loudness;
    voice.until = now + Waves.seconds(sound) / pitch;
    voice.id = speaker.play(sound, volume * loudness, aside, pitch);
  }

  /** What didn't happen falls silent. */
  @Override
  public void retracted(Event event) {
    for (Voice voice : voices) {
      if (playing(voice) && voice.event.tick() == event.tick() && voice.event.isLike(event)) {
        stop(voice);
        return;
      }
    }
  }

  private static float hardness(Event event) {
    EventKind kind = event.kind();
    return kind.fullStrength() == 0
        ? 1
        : MathUtils.clamp(event.strength() / kind.fullStrength(), 0, 1);
  }

  private float nearness(Event event) {
    float near = NEAR_M + 2 * event.kind().radius();
    float dx = event.x() - earX;
    float dy = event.y() - earY;
    return 1 / (1 + (dx * dx + dy * dy) / (near * near));
  }

  /** A voice that is free, or else the one that is missed least. */
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
      speaker.stop(voice.event.kind().sound(), voice.id);
    }
  }
}
