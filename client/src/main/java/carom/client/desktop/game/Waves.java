package carom.client.desktop.game;

import carom.sim.event.Sound;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Computes the sounds: one channel of 16 bits. They begin and end in silence. */
final class Waves {
  /** Samples per second. */
  static final int RATE = 32_000;

  private static final double LOUDEST = 0.9;
  private static final double ATTACK_SECONDS = 0.003;
  private static final double RELEASE_SECONDS = 0.01;
  private static final double TWO_PI = 2 * Math.PI;
  private static final int HEADER = 44;

  private Waves() {}

  /** Returns the length of a sound, seconds. */
  static float seconds(Sound sound) {
    return switch (sound) {
      case NONE -> 0;
      case KNOCK, HOP -> 0.14f;
      case WHOOSH -> 0.3f;
      case ZAP -> 0.25f;
      case CHIME -> 0.4f;
      case DROP -> 0.5f;
      case FANFARE -> 1;
    };
  }

  /** Returns the samples of a sound; the loudest has full scale. */
  static short[] samples(Sound sound) {
    double[] wave = new double[Math.round(seconds(sound) * RATE)];
    Noise noise = new Noise();
    double phase = 0; // turns
    for (int i = 0; i < wave.length; i++) {
      double t = i / (double) RATE;
      double left = 1 - i / (double) wave.length;
      phase += hertz(sound, t) / RATE;
      wave[i] =
          switch (sound) {
            case NONE -> 0;
            case KNOCK -> sine(phase) * Math.exp(-28 * t) + 0.5 * noise.at(0.6) * Math.exp(-90 * t);
            case WHOOSH -> noise.at(0.06 + 0.2 * left) * left * Math.min(1, 12 * t);
            case ZAP -> (saw(phase) + 0.4 * noise.at(0.8)) * left * left;
            case HOP -> sine(phase) * left;
            case CHIME -> (sine(phase) + 0.4 * sine(2 * phase)) * Math.exp(-9 * t);
            case DROP -> (sine(phase) + 0.3 * sine(2 * phase)) * left;
            case FANFARE -> (saw(phase) * 0.4 + sine(phase)) * left * pulse(t);
          };
    }
    return loud(wave);
  }

  /** Returns the pitch of a sound at a time, hertz. */
  private static double hertz(Sound sound, double t) {
    return switch (sound) {
      case NONE, WHOOSH -> 0;
      case KNOCK -> 170 + 260 * Math.exp(-60 * t);
      case ZAP -> 140 + 1_500 * Math.exp(-14 * t);
      case HOP -> 260 + 2_600 * t;
      case CHIME -> t < 0.08 ? 988 : 1_319; // B5, E6
      case DROP -> 420 * Math.exp(-3 * t);
      case FANFARE -> t < 0.15 ? 392 : t < 0.3 ? 523 : t < 0.45 ? 659 : 784; // G4, C5, E5, G5
    };
  }

  private static double pulse(double t) {
    return t < 0.45 ? 1 - 0.6 * (t % 0.15) / 0.15 : 1;
  }

  private static double sine(double turns) {
    return Math.sin(TWO_PI * turns);
  }

  /** Returns a saw tooth of few harmonics. */
  private static double saw(double turns) {
    return (sine(turns) + sine(2 * turns) / 2 + sine(3 * turns) / 3 + sine(4 * turns) / 4) / 1.5;
  }

  /** Noise through a low pass, the same for each sound. */
  private static final class Noise {
    private int seed = 1;
    private double low;

    /**
     * Returns the next sample.
     *
     * @param open how much of the high is let through, 0..1
     */
    double at(double open) {
      seed = seed * 1_664_525 + 1_013_904_223; // Numerical Recipes' generator
      low += open * (seed / (double) Integer.MAX_VALUE - low);
      return low;
    }
  }

  private static short[] loud(double[] wave) {
    double most = 1e-9;
    for (int i = 0; i < wave.length; i++) {
      double begun = i / (ATTACK_SECONDS * RATE);
      double left = (wave.length - 1 - i) / (RELEASE_SECONDS * RATE);
      wave[i] *= Math.min(1, Math.min(begun, left));
      most = Math.max(most, Math.abs(wave[i]));
    }
    short[] samples = new short[wave.length];
    for (int i = 0; i < wave.length; i++) {
      samples[i] = (short) Math.round(wave[i] / most * LOUDEST * Short.MAX_VALUE);
    }
    return samples;
  }

  /** Returns a sound as a WAV file: PCM, one channel. */
  static byte[] wav(Sound sound) {
    short[] samples = samples(sound);
    int bytes = 2 * samples.length;
    ByteBuffer out = ByteBuffer.allocate(HEADER + bytes).order(ByteOrder.LITTLE_ENDIAN);
    out.put(ascii("RIFF")).putInt(HEADER - 8 + bytes).put(ascii("WAVE"));
    out.put(ascii("fmt ")).putInt(16).putShort((short) 1).putShort((short) 1);
    out.putInt(RATE).putInt(2 * RATE).putShort((short) 2).putShort((short) 16);
    out.put(ascii("data")).putInt(bytes);
    out.asShortBuffer().put(samples);
    return out.array();
  }

  private static byte[] ascii(String text) {
    return text.getBytes(StandardCharsets.US_ASCII);
  }
}
