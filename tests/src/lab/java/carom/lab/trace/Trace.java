package carom.lab.trace;

import carom.net.codec.Quantizer;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A recording of bodies that move. As a file: little-endian int32 bodies, int32 ticks, int32 hz,
 * then float32 x, y (m), angle (rad), vx, vy (m/s), omega (rad/s) for each tick and body.
 * Immutable.
 */
public final class Trace {

  /** Steps per metre per second of a velocity. */
  public static final int VELOCITY_STEPS = 64;

  /** Steps per radian per second of an angular velocity. */
  public static final int OMEGA_STEPS = 32;

  /** Largest magnitude of a quantised velocity: 2,048 m/s. */
  public static final int MAX_VELOCITY = 1 << 17;

  /** Largest magnitude of a quantised angular velocity: 1,024 rad/s. */
  public static final int MAX_OMEGA = 1 << 15;

  private static final int HEADER_BYTES = 12;
  private static final int NUMBERS = 6;
  private static final int BODY_BYTES = NUMBERS * Float.BYTES;
  private static final int MAX_HZ = 100_000;
  private static final String[] NAMES = {"x", "y", "angle", "vx", "vy", "omega"};
  private static final double[] LIMITS = {
    Quantizer.positionOf(Quantizer.MAX_POSITION),
    Quantizer.positionOf(Quantizer.MAX_POSITION),
    1e9,
    (float) MAX_VELOCITY / VELOCITY_STEPS,
    (float) MAX_VELOCITY / VELOCITY_STEPS,
    (float) MAX_OMEGA / OMEGA_STEPS
  };

  private final int bodies;
  private final int ticks;
  private final int hz;
  private final ByteBuffer numbers;

  private Trace(int bodies, int ticks, int hz, ByteBuffer numbers) {
    this.bodies = bodies;
    this.ticks = ticks;
    this.hz = hz;
    this.numbers = numbers;
  }

  /**
   * Reads a file.
   *
   * @throws IOException if it can't be read, or isn't a trace; the message names the wrong number
   */
  public static Trace read(Path file) throws IOException {
    if (Files.isDirectory(file)) {
      throw new IOException(file + " is a directory, not a trace");
    }
    long size = Files.size(file);
    if (size < HEADER_BYTES || size > Integer.MAX_VALUE - 8) {
      throw new IOException(
          file
              + ": size="
              + size
              + " bytes is outside "
              + HEADER_BYTES
              + ".."
              + (Integer.MAX_VALUE - 8));
    }
    ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.LITTLE_ENDIAN);
    int bodies = bytes.getInt();
    int ticks = bytes.getInt();
    int hz = bytes.getInt();
    check(file, "bodies", bodies, TraceCodec.MAX_BODIES);
    check(file, "ticks", ticks, Integer.MAX_VALUE);
    check(file, "hz", hz, MAX_HZ);
    long expected = HEADER_BYTES + (long) bodies * ticks * BODY_BYTES;
    if (expected != bytes.capacity()) {
      throw new IOException(
          file
              + ": size="
              + bytes.capacity()
              + " bytes, but bodies="
              + bodies
              + " ticks="
              + ticks
              + " need "
              + expected);
    }
    return new Trace(bodies, ticks, hz, bytes.slice().order(ByteOrder.LITTLE_ENDIAN));
  }

  private static void check(Path file, String name, int value, int max) throws IOException {
    if (value < 1 || value > max) {
      throw new IOException(file + ": " + name + "=" + value + " is outside 1.." + max);
    }
  }

  /**
   * Creates a trace.
   *
   * @param bodies 1..{@link TraceCodec#MAX_BODIES}
   * @param hz ticks per second
   * @param numbers x, y, angle, vx, vy, omega for each tick and body; copied
   */
  public static Trace of(int bodies, int hz, float[] numbers) {
    int perTick = bodies * NUMBERS;
    if (bodies < 1 || bodies > TraceCodec.MAX_BODIES || hz < 1 || hz > MAX_HZ) {
      throw new IllegalArgumentException("bodies=" + bodies + " hz=" + hz + " is out of range");
    }
    if (numbers.length == 0 || numbers.length % perTick != 0) {
      throw new IllegalArgumentException(
          "numbers.length=" + numbers.length + " is not a multiple of " + perTick);
    }
    ByteBuffer copy =
        ByteBuffer.allocate(numbers.length * Float.BYTES).order(ByteOrder.LITTLE_ENDIAN);
    copy.asFloatBuffer().put(numbers);
    return new Trace(bodies, numbers.length / perTick, hz, copy);
  }

  /** Writes the file and replaces an existing one. */
  public void write(Path file) throws IOException {
    ByteBuffer bytes =
        ByteBuffer.allocate(HEADER_BYTES + numbers.capacity()).order(ByteOrder.LITTLE_ENDIAN);
    bytes.putInt(bodies).putInt(ticks).putInt(hz).put(numbers.duplicate().clear());
    Files.write(file, bytes.array());
  }

  /** Returns the number of bodies. */
  public int bodies() {
    return bodies;
  }

  /** Returns the number of ticks. */
  public int ticks() {
    return ticks;
  }

  /** Returns the number of ticks per second. */
  public int hz() {
    return hz;
  }

  /**
   * Returns one of the six numbers of a body, in the file's order.
   *
   * @param number 0..5
   */
  public float number(int tick, int body, int number) {
    return numbers.getFloat(((tick * bodies) + body) * BODY_BYTES + number * Float.BYTES);
  }

  /**
   * Quantises a tick with the steps of {@link Quantizer}, and velocities with those above.
   *
   * @param tick 0..ticks - 1
   * @param fields {@link TraceCodec#POSE} or {@link TraceCodec#FULL}
   * @param state receives it by field, then by body
   * @throws IllegalArgumentException if a number isn't finite or is beyond what can be quantised
   */
  public void quantize(int tick, int fields, int[][] state) {
    for (int i = 0; i < bodies; i++) {
      for (int f = 0; f < fields; f++) {
        float value = number(tick, i, f);
        if (!(Math.abs(value) <= LIMITS[f])) {
          throw new IllegalArgumentException(
              "tick="
                  + tick
                  + " body="
                  + i
                  + ": "
                  + NAMES[f]
                  + "="
                  + value
                  + " is outside +-"
                  + LIMITS[f]
                  + ", the range of the quantiser");
        }
        state[f][i] =
            switch (f) {
              case 0, 1 -> Quantizer.position(value);
              case 2 -> Quantizer.angle(value);
              case 3, 4 -> (int) Math.floor(value * VELOCITY_STEPS + 0.5);
              default -> (int) Math.floor(value * OMEGA_STEPS + 0.5);
            };
      }
    }
  }
}
