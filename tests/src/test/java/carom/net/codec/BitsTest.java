package carom.net.codec;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class BitsTest {

  private static final long SEED = 4711;

  @Test
  void whatIsWrittenIsReadBitByBit() {
    Random random = new Random(SEED);
    for (int round = 0; round < 500; round++) {
      int offset = random.nextInt(5);
      int length = random.nextInt(60);
      byte[] bytes = new byte[offset + length + 9];
      random.nextBytes(bytes);
      byte[] before = bytes.clone();
      BitWriter w = new BitWriter();
      w.reset(bytes, offset, length);
      int[] values = new int[600];
      int[] counts = new int[600];
      int n = 0;
      while (n < 600) {
        values[n] = random.nextInt();
        counts[n] = random.nextInt(33);
        int bits = w.bits();
        w.write(values[n], counts[n]);
        if (w.overflow()) {
          assertEquals(bits, w.bits(), "an overflow writes nothing");
          assertTrue(bits + counts[n] > 8 * length, "seed=" + SEED);
          break;
        }
        n++;
      }
      BitReader r = new BitReader();
      r.reset(bytes, offset, w.bytes());
      for (int i = 0; i < n; i++) {
        int mask = counts[i] == 32 ? -1 : (1 << counts[i]) - 1;
        assertEquals(values[i] & mask, r.read(counts[i]), "seed=" + SEED + " round=" + round);
      }
      assertTrue(r.finished(), "seed=" + SEED + " round=" + round);
      for (int i = 0; i < bytes.length; i++) {
        if (i < offset || i >= offset + length) {
          assertEquals(before[i], bytes[i], "outside the room, index=" + i);
        }
      }
    }
  }

  @Test
  void readingPastTheEndFailsForGood() {
    BitReader r = new BitReader();
    r.reset(new byte[] {-1, -1}, 0, 2);
    assertEquals(0x3fff, r.read(14));
    assertFalse(r.failed());
    assertEquals(0, r.read(3));
    assertTrue(r.failed());
    assertEquals(0, r.read(1), "sticky, although a bit is left");
    assertEquals(0, r.remaining());
    assertFalse(r.finished());
  }

  @Test
  void leftOversAreNotFinished() {
    BitReader r = new BitReader();
    r.reset(new byte[] {1, 5, 9}, 0, 3);
    assertEquals(1, r.read(3));
    assertEquals(1, r.align());
    assertEquals(1, r.align(), "already there");
    assertEquals(5, r.read(3));
    assertEquals(2, r.align());
    assertEquals(1, r.read(1));
    assertFalse(r.failed());
    r.align();
    assertTrue(r.failed(), "a bit of the last byte is left over");
    r.reset(new byte[] {1, 0}, 0, 2);
    r.read(1);
    assertFalse(r.finished(), "a whole byte remains");
    r.reset(new byte[] {3}, 0, 1);
    r.read(1);
    assertFalse(r.finished(), "the rest of the last byte is not zero");
    r.reset(new byte[] {1}, 0, 1);
    r.read(1);
    assertTrue(r.finished());
    r.reset(new byte[] {1}, 0, 1);
    r.read(8);
    r.fail();
    assertFalse(r.finished(), "a decoder said no");
  }

  @Test
  void rewindForgetsWhatCameAfter() {
    byte[] bytes = new byte[4];
    Arrays.fill(bytes, (byte) -1);
    BitWriter w = new BitWriter();
    w.reset(bytes, 0, 2);
    w.write(0b101, 3);
    w.write(-1, 32);
    assertTrue(w.overflow());
    w.rewind(3);
    assertFalse(w.overflow());
    w.write(-1, 10);
    w.rewind(3);
    assertEquals(1, w.bytes());
    assertEquals(0b101, bytes[0], "bits after the mark are zero");
    assertThrows(IllegalArgumentException.class, () -> w.rewind(4));
    assertThrows(IndexOutOfBoundsException.class, () -> w.reset(bytes, 3, 2));
  }

  @Test
  void orderedFloatsFollowTheNumbersAndComeBackBitByBit() {
    float[] ascending = {
      Float.NEGATIVE_INFINITY, -1e30f, -1, -Float.MIN_VALUE, -0f, 0f, Float.MIN_VALUE, 1, 1e30f
    };
    for (int i = 1; i < ascending.length; i++) {
      assertTrue(Bits.ordered(ascending[i - 1]) < Bits.ordered(ascending[i]));
    }
    assertEquals(1, Bits.ordered(0f) - Bits.ordered(-0f));
    Random random = new Random(SEED);
    for (int i = 0; i < 10_000; i++) {
      int raw = random.nextInt();
      assertEquals(raw, Bits.rawBits(Bits.orderedBits(raw)), "NaNs too, seed=" + SEED);
    }
  }

  @Test
  void zigzagAndWidth() {
    for (int value : new int[] {0, -1, 1, -2, 2, Integer.MAX_VALUE, Integer.MIN_VALUE}) {
      assertEquals(value, Bits.unzigzag(Bits.zigzag(value)));
    }
    assertEquals(3, Bits.zigzag(-2));
    assertEquals(0, Bits.width(0));
    assertEquals(3, Bits.width(7));
    assertEquals(32, Bits.width(-1));
  }

  @Test
  void sequencesWrap() {
    assertEquals(0, Sequence.next(0xffff));
    assertEquals(2, Sequence.difference(1, 0xffff));
    assertTrue(Sequence.isNewer(3, 0xfff0));
    assertFalse(Sequence.isNewer(0xfff0, 3));
    for (int near : new int[] {0, 5, 65_530, 65_540, 1_000_000}) {
      for (int d = -30_000; d <= 30_000; d += 777) {
        assertEquals(near + d, Sequence.expand((near + d) & 0xffff, near));
      }
    }
  }
}
