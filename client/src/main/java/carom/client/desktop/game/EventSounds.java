package carom.client.desktop.game;

import carom.client.EventListener;
import carom.sim.event.EventKind;
import carom.sim.event.Sound;
import carom.sim.outbox.Event;
import com.badlogic.gdx.math.MathUtils;

/**
 * Plays the sounds of events, louder if they are hard and near, and from the side they come from.
 * Of many events at the same time the loudest are heard. Render thread only; no allocation per
 * event.
 */
public final class EventSounds implements EventListener {
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
  }

  /** Switches the sound off or on; playing sounds stop. */
  public void mute(boolean silent) {
    muted = silent;
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
    float aside = MathUtils.clamp((event.x() - listenerX) / ASIDE_M, -MOST_ASIDE, MOST_ASIDE);
    voice.event.set(event);
    voice.loudness = loudness;
    voice.until = now + Waves.seconds(sound) / pitch;
    voice.id = speaker.play(sound, volume * loudness, aside, pitch);
  }

  /** Stops the sound of an event that did not happen. */
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
    float dx = event.x() - listenerX;
    float dy = event.y() - listenerY;
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
      speaker.stop(voice.event.kind().sound(), voice.id);
    }
  }
}
