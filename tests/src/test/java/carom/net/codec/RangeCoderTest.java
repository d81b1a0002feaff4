package carom.net.codec;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.lab.trace.NumberModel;
import java.math.BigInteger;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * The arithmetic coder: exact, close to the bits' surprise, and never at the mercy of its bytes.
 */
final class RangeCoderTest {
  private static final long SEED = 20_261_122;

  private final RangeEncoder encoder = new RangeEncoder();
  private final RangeDecoder decoder = new RangeDecoder();
  private final byte[] buffer = new byte[1 << 16];

  /** Probabilities from evenly spread to extreme, and bits that follow them or defy them. */
  private static int probability(Random random) {
    return switch (random.nextInt(4)) {
      case 0 -> 1;
      case 1 -> 65_535;
      case 2 -> 1 + random.nextInt(65_535);
      default -> 1 << random.nextInt(16);
    };
  }

  @Test
  void whatWasWrittenIsReadAndEveryByteIsNeeded() {
    Random random = new Random(SEED);
    for (int round = 0; round < 3_000; round++) {
      int n = random.nextInt(200);
      int[] bits = new int[n];
      int[] probabilities = new int[n];
      encoder.reset(buffer, 0, buffer.length);
      for (int i = 0; i < n; i++) {
        probabilities[i] = probability(random);
        boolean likely = random.nextInt(8) != 0;
        bits[i] = likely == probabilities[i] > 32_768 ? 1 : 0;
        assertEquals(bits[i], encoder.code(bits[i], probabilities[i]));
      }
      int length = encoder.finish();
      assertFalse(encoder.overflow());
      byte[] message = Arrays.copyOf(buffer, length);
      assertTrue(reads(message, bits, probabilities), "seed " + SEED + " round " + round);
      assertFalse(reads(Arrays.copyOf(message, length + 1), bits, probabilities));
      if (length > 0) {
        assertFalse(reads(Arrays.copyOf(message, length - 1), bits, probabilities));
        message[random.nextInt(length)] ^= (byte) (1 << random.nextInt(8));
        assertFalse(reads(message, bits, probabilities));
      }
    }
  }

  @Test
  void slicesWorkedOutBeforeAreTheSameBytesAsBitsOneByOneAndLeaveNoTraceWhenTakenBack() {
    Random random = new Random(SEED);
    RangeEncoder other = new RangeEncoder();
    byte[] out = new byte[buffer.length];
    SliceList list = new SliceList();
    for (int round = 0; round < 300; round++) {
      encoder.reset(buffer, 0, buffer.length);
      other.reset(out, 0, out.length);
      list.clear();
      for (int part = 0; part < 20; part++) {
        int from = list.size();
        int n = random.nextInt(60);
        int[] bits = new int[n];
        int[] probabilities = new int[n];
        for (int i = 0; i < n; i++) {
          bits[i] = random.nextInt(2);
          probabilities[i] = probability(random);
          list.code(bits[i], probabilities[i]);
        }
        list.cut();
        if (random.nextBoolean()) {
          other.mark();
          other.slices(list, from, list.size());
          other.code(1, 1);
          other.rewind();
        }
        if (random.nextInt(4) == 0) {
          list.shorten(from);
          continue;
        }
        other.slices(list, from, list.size());
        for (int i = 0; i < n; i++) {
          encoder.code(bits[i], probabilities[i]);
        }
        encoder.cut();
        assertEquals(encoder.bits(), other.bits());
      }
      int length = encoder.finish();
      assertEquals(length, other.finish());
      assertArrayEquals(Arrays.copyOf(buffer, length), Arrays.copyOf(out, length));
    }
  }

  /** The same interval in numbers without end, which need no words and no carry. */
  @Test
  void theMessageIsTheShortestFractionOfTheExactInterval() {
    Random random = new Random(SEED);
    int carries = 0;
    for (int round = 0; round < 2_000; round++) {
      encoder.reset(buffer, 0, buffer.length);
      BigInteger low = BigInteger.ZERO;
      BigInteger range = BigInteger.ONE.shiftLeft(64).subtract(BigInteger.ONE);
      int shifted = 0;
      for (int i = random.nextInt(40); i > 0; i--) {
        long width = 1 + (random.nextLong() >>> 16 + random.nextInt(40));
        long first = random.nextInt(3) == 0 ? SliceWriter.ALL - width : random.nextLong() >>> 16;
        first = Math.min(first, SliceWriter.ALL - width);
        encoder.slice(first, width);
        BigInteger step = range.shiftRight(SliceWriter.BITS);
        BigInteger before = low.shiftRight(64);
        low = low.add(step.multiply(BigInteger.valueOf(first)));
        carries += low.shiftRight(64).equals(before) ? 0 : 1;
        range = step.multiply(BigInteger.valueOf(width));
        while (range.bitLength() <= RangeEncoder.RANGE_BITS) {
          low = low.shiftLeft(Byte.SIZE);
          range = range.shiftLeft(Byte.SIZE);
          shifted += Byte.SIZE;
        }
      }
      int length = encoder.finish();
      BigInteger written = new BigInteger(1, Arrays.copyOf(buffer, length));
      BigInteger value = written.shiftLeft(64 + shifted).shiftRight(8 * length);
      assertTrue(value.compareTo(low) >= 0, "seed " + SEED + " round " + round);
      assertTrue(value.compareTo(low.add(range)) < 0, "seed " + SEED + " round " + round);
      BigInteger unit = BigInteger.ONE.shiftLeft(Math.max(0, 64 + shifted - 8 * (length - 1)));
      BigInteger shorter = low.add(unit).subtract(BigInteger.ONE).divide(unit).multiply(unit);
      assertTrue(length == 0 || shorter.compareTo(low.add(range)) >= 0, "a byte less would do");
    }
    assertTrue(carries > 100, "carries=" + carries);
  }

  @Test
  void aSliceIsSplitAsTheExactProductSaysAndBothBitsKeepAPart() {
    Random random = new Random(SEED);
    for (int i = 0; i < 10_000; i++) {
      long width = Math.max(2, SliceWriter.ALL >>> random.nextInt(40));
      width = Math.max(2, width - random.nextInt(1 << 7));
      int probability = probability(random);
      BigInteger product = BigInteger.valueOf(width - 1).multiply(BigInteger.valueOf(probability));
      long ones = SliceWriter.ones(width, probability);
      assertEquals(product.shiftRight(16).longValueExact() + 1, ones);
      assertTrue(ones >= 1 && ones < width, "width=" + width + " ones=" + ones);
    }
  }

  @Test
  void surpriseIsWhatTheMessageTakes() {
    Random random = new Random(SEED);
    BitCost surprise = new BitCost();
    encoder.reset(buffer, 0, buffer.length);
    for (int i = 0; i < 20_000; i++) {
      int p = 2_000 + random.nextInt(61_000);
      int bit = random.nextInt(65_536) < p ? 1 : 0;
      surprise.code(bit, p);
      encoder.code(bit, p);
    }
    assertEquals(encoder.bits(), surprise.sum() / 256.0, 0.01 * encoder.bits());
  }

  /** Rows of few and of many symbols, even and steep. */
  private static SymbolTable table(Random random, int symbols) {
    SymbolTable table = new SymbolTable(5, symbols);
    for (int row = 1; row < 5; row++) {
      double[] weights = new double[symbols];
      for (int s = 0; s < symbols; s++) {
        weights[s] = Math.pow(random.nextDouble(), 4 * row) + (s == row ? 1 : 0);
      }
      table.set(row, weights);
    }
    return table;
  }

  @Test
  void symbolsAndPlainNumbersComeBackAsShortAsTheirSurprise() {
    Random random = new Random(SEED);
    BitCost surprise = new BitCost();
    for (int round = 0; round < 2_000; round++) {
      SymbolTable table = table(random, 1 + random.nextInt(128));
      int n = random.nextInt(200);
      int[][] items = new int[n][];
      encoder.reset(buffer, 0, buffer.length);
      surprise.reset();
      for (int i = 0; i < n; i++) {
        int most = random.nextInt(3) == 0 ? random.nextInt(table.last() + 1) : table.last();
        int row = random.nextInt(5);
        int count = random.nextInt(33);
        items[i] =
            switch (random.nextInt(4)) {
              case 0 -> new int[] {0, random.nextInt(2), probability(random)};
              case 1 -> new int[] {1, random.nextInt() & (int) ((1L << count) - 1), count};
              case 2 -> new int[] {2, random.nextInt(most + 1), row, most};
              default -> new int[] {2, Math.min(most, row), row, most};
            };
        assertEquals(items[i][1], code(encoder, table, items[i], items[i][1]));
        code(surprise, table, items[i], items[i][1]);
        if (random.nextInt(9) == 0) {
          encoder.cut();
          items[i][0] += 3;
        }
      }
      int length = encoder.finish();
      assertTrue(length <= surprise.sum() * 1.01 / 256 / 8 + 2 + n / 20.0, length + " bytes");
      byte[] message = Arrays.copyOf(buffer, length);
      String where = "seed " + SEED + " round " + round;
      assertTrue(readsItems(message, table, items), where);
      assertFalse(readsItems(Arrays.copyOf(message, length + 1), table, items), where);
      if (length > 0) {
        assertFalse(readsItems(Arrays.copyOf(message, length - 1), table, items), where);
        message[random.nextInt(length)] ^= (byte) (1 << random.nextInt(8));
        assertFalse(readsItems(message, table, items), where);
      }
    }
  }

  private static int code(BitCoder c, SymbolTable table, int[] item, int value) {
    return switch (item[0] % 3) {
      case 0 -> c.code(value, item[2]);
      case 1 -> c.plain(value, item[2]);
      default -> c.symbol(table, item[2], value, item[3]);
    };
  }

  private boolean readsItems(byte[] message, SymbolTable table, int[][] items) {
    decoder.reset(message, 0, message.length);
    boolean equal = true;
    for (int[] item : items) {
      equal &= code(decoder, table, item, 0) == item[1];
      if (item[0] > 2) {
        decoder.cut();
      }
    }
    return equal && decoder.finished();
  }

  @Test
  void everySymbolHasAPartAndAllPartsTogetherAreAll() {
    Random random = new Random(SEED);
    for (int round = 0; round < 200; round++) {
      SymbolTable table = table(random, 1 + random.nextInt(128));
      for (int row = 0; row < 5; row++) {
        assertEquals(0, table.from(row, 0));
        assertEquals(SymbolTable.ALL, table.from(row, table.last() + 1));
        for (int s = 0; s <= table.last(); s++) {
          int from = table.from(row, s);
          int to = table.from(row, s + 1);
          assertTrue(from < to, "symbol=" + s);
          assertEquals(s, table.find(row, from));
          assertEquals(s, table.find(row, to - 1));
        }
      }
    }
    assertThrows(IllegalArgumentException.class, () -> new SymbolTable(1, 129));
    assertThrows(IllegalArgumentException.class, () -> new SymbolTable(1, 2).set(0, new double[1]));
  }

  private boolean reads(byte[] message, int[] bits, int[] probabilities) {
    decoder.reset(message, 0, message.length);
    boolean equal = true;
    for (int i = 0; i < bits.length; i++) {
      equal &= decoder.code(0, probabilities[i]) == bits[i];
    }
    return equal && decoder.finished();
  }

  @Test
  void whateverIsAcceptedIsWhatAnEncoderWrites() {
    Random random = new Random(SEED);
    int accepted = 0;
    for (int round = 0; round < 20_000; round++) {
      byte[] message = new byte[random.nextInt(4)];
      random.nextBytes(message);
      decoder.reset(message, 0, message.length);
      SymbolTable table = table(random, 3);
      int[] bits = new int[random.nextInt(24)];
      for (int i = 0; i < bits.length; i++) {
        bits[i] = any(decoder, table, i, 0);
      }
      if (decoder.finished()) {
        accepted++;
        encoder.reset(buffer, 0, buffer.length);
        for (int i = 0; i < bits.length; i++) {
          any(encoder, table, i, bits[i]);
        }
        assertArrayEquals(message, Arrays.copyOf(buffer, encoder.finish()));
      }
    }
    assertTrue(accepted > 100, "accepted=" + accepted);
  }

  private static int any(BitCoder c, SymbolTable table, int i, int value) {
    return switch (i % 3) {
      case 0 -> c.code(value, 20_000);
      case 1 -> c.symbol(table, 1, value, 2);
      default -> c.even(value, 1);
    };
  }

  @Test
  void aMessageIsAsLongAsItsSurprise() {
    Random random = new Random(SEED);
    double surprise = 0;
    encoder.reset(buffer, 0, buffer.length);
    for (int i = 0; i < 100_000; i++) {
      int p = 1 + random.nextInt(65_535);
      int bit = random.nextInt(65_536) < p ? 1 : 0;
      surprise -= Math.log((bit == 1 ? p : 65_536 - p) / 65_536.0) / Math.log(2);
      encoder.code(bit, p);
    }
    assertEquals(surprise / 8, encoder.finish(), 2);
  }

  @Test
  void noBitsAreNoBytesAndPlainNumbersKeepTheirBits() {
    encoder.reset(buffer, 0, 0);
    assertEquals(0, encoder.finish());
    encoder.reset(buffer, 3, 100);
    encoder.plain(0xdeadbeef, 32);
    encoder.plain(5, 3);
    encoder.plain(0, 0);
    int length = encoder.finish();
    assertTrue(length <= 5);
    decoder.reset(buffer, 3, length);
    assertEquals(0xdeadbeef, decoder.plain(0, 32));
    assertEquals(5, decoder.plain(0, 3));
    assertTrue(decoder.finished());
    decoder.fail();
    assertFalse(decoder.finished());
  }

  @Test
  void writingPastTheRoomIsToldAndTouchesNothingElse() {
    byte[] room = new byte[8];
    Arrays.fill(room, (byte) 7);
    encoder.reset(room, 2, 3);
    encoder.plain(0x12345678, 32);
    encoder.plain(0x12345678, 32);
    encoder.finish();
    assertTrue(encoder.overflow());
    assertArrayEquals(new byte[] {7, 7}, Arrays.copyOf(room, 2));
    assertArrayEquals(new byte[] {7, 7, 7}, Arrays.copyOfRange(room, 5, 8));
    assertThrows(IndexOutOfBoundsException.class, () -> encoder.reset(room, 6, 3));
    assertThrows(IndexOutOfBoundsException.class, () -> decoder.reset(room, -1, 3));
  }

  @Test
  void numbersOfEverySizeComeBackAndLearningMakesThemShorter() {
    Random random = new Random(SEED);
    NumberModel writing = new NumberModel(2, 16, 2);
    NumberModel reading = new NumberModel(2, 16, 2);
    int[] lengths = new int[40];
    for (int round = 0; round < lengths.length; round++) {
      int[] values = new int[200];
      int[] contexts = new int[values.length];
      for (int i = 0; i < values.length; i++) {
        contexts[i] = random.nextInt(16);
        values[i] = (int) Math.round(random.nextGaussian() * contexts[i]);
      }
      values[0] = NumberModel.MAX;
      values[1] = -NumberModel.MAX;
      values[2] = random.nextInt() >> 5 + random.nextInt(27);
      encoder.reset(buffer, 0, buffer.length);
      for (int i = 0; i < values.length; i++) {
        context(writing, contexts[i]);
        writing.code(encoder, values[i], true);
      }
      lengths[round] = encoder.finish();
      decoder.reset(buffer, 0, lengths[round]);
      for (int i = 0; i < values.length; i++) {
        context(reading, contexts[i]);
        assertEquals(values[i], reading.code(decoder, 0, true), "round " + round + " value " + i);
      }
      assertTrue(decoder.finished());
    }
    assertTrue(lengths[39] < 0.9 * lengths[0], Arrays.toString(lengths));
  }

  private static void context(NumberModel model, int value) {
    model.context(0, value);
    model.context(1, 0);
    model.situation(value >> 3);
  }
}
