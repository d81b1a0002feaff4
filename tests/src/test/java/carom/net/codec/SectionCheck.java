package carom.net.codec;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import java.util.function.Function;
import java.util.function.Supplier;

/**
 * Checks that a section of a datagram is the same whichever way a pass goes: measured, written and
 * read it has the same values and bits; cut at any bit, the reader fails; and no bits make it
 * throw.
 *
 * @param <T> what the section describes
 */
public final class SectionCheck<T> {

  /** The one description of a section. */
  public interface Section<T> {
    /** Codes a state. */
    void code(BitPass c, T state);
  }

  private static final int MAX_BYTES = 1 << 12;

  private final Section<T> section;
  private final Supplier<T> target;
  private final Function<T, String> text;
  private final BitWriter writer = new BitWriter();
  private final BitReader reader = new BitReader();
  private final byte[] bytes = new byte[MAX_BYTES];

  /**
   * Creates a check.
   *
   * @param target gives what a reader fills; it may hold anything
   * @param text says all values of a state
   */
  public SectionCheck(Section<T> section, Supplier<T> target, Function<T, String> text) {
    this.section = section;
    this.target = target;
    this.text = text;
  }

  /** Checks one state and returns its bits. */
  public int check(T state) {
    String expected = text.apply(state);
    BitMeter meter = new BitMeter();
    section.code(meter, state);
    assertEquals(expected, text.apply(state), "measuring changes nothing");
    for (int pad = 0; pad < Byte.SIZE; pad++) {
      write(state, pad, meter.bits());
      assertEquals(expected, text.apply(state), "writing changes nothing");
      assertEquals(expected, text.apply(read(pad, meter.bits())));
      assertFalse(reader.failed());
      // Behind so many bits, the end of a byte is the end of the section's bit `cut`.
      for (int cut = -pad & Byte.SIZE - 1; cut < meter.bits(); cut += Byte.SIZE) {
        read(pad, cut);
        assertTrue(reader.failed(), "cut=" + cut + " of bits=" + meter.bits());
      }
    }
    return meter.bits();
  }

  private void write(T state, int pad, int expectedBits) {
    writer.reset(bytes, 0, bytes.length);
    writer.write(0, pad);
    section.code(writer, state);
    assertFalse(writer.overflow());
    assertEquals(expectedBits, writer.bits() - pad, "measured and written");
  }

  private T read(int pad, int bits) {
    int length = (pad + bits + Byte.SIZE - 1) / Byte.SIZE;
    reader.reset(bytes, 0, length);
    reader.read(pad);
    T state = target.get();
    section.code(reader, state);
    if (!reader.failed()) {
      assertEquals(pad + bits, length * Byte.SIZE - reader.remaining(), "written and read");
    }
    return state;
  }

  /** Reads bytes that nobody wrote: anything but an exception is right. */
  public void hostile(Random random, int count) {
    for (int i = 0; i < count; i++) {
      random.nextBytes(bytes);
      if (random.nextBoolean()) {
        Arrays.fill(bytes, random.nextInt(80), bytes.length, (byte) -1);
      }
      reader.reset(bytes, 0, random.nextInt(bytes.length));
      section.code(reader, target.get());
    }
  }
}
