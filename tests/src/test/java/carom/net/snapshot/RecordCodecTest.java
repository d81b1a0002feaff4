package carom.net.snapshot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.BitCoder;
import carom.net.codec.Quantizer;
import carom.net.codec.RangeDecoder;
import carom.net.codec.RangeEncoder;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Records of every kind and size, written and read by the same lines. */
final class RecordCodecTest {
  private static final long SEED = 77_003;

  private final RangeEncoder encoder = new RangeEncoder();
  private final RangeDecoder decoder = new RangeDecoder();
  private final RecordCodec writing = new RecordCodec();
  private final RecordCodec reading = new RecordCodec();
  private final DeltaCodec deltas = new DeltaCodec(60);
  private final byte[] buffer = new byte[1 << 16];

  private static int any(Random random, int max) {
    int sign = random.nextBoolean() ? 1 : -1;
    return sign
        * (random.nextInt(9) == 0 ? max : random.nextInt(1 << random.nextInt(25)) % (max + 1));
  }

  private static Motion motion(Random random) {
    Motion m = new Motion();
    m.x = any(random, Quantizer.MAX_POSITION);
    m.y = any(random, Quantizer.MAX_POSITION);
    m.angle = random.nextInt(Quantizer.ANGLE_STEPS);
    if (random.nextBoolean()) {
      m.vx = any(random, Quantizer.MAX_VELOCITY);
      m.vy = any(random, Quantizer.MAX_VELOCITY);
      m.omega = any(random, Quantizer.MAX_OMEGA);
    }
    return m;
  }

  /** Codes one record; what it was given or what was read goes into the answer. */
  private int[] record(RecordCodec codec, BitCoder c, int[] r, Motion baseline, Motion m) {
    int[] out = r.clone();
    out[1] = codec.head(c, r[1], r[0], r[2], r[7]);
    if (out[1] == RecordCodec.END) {
      return out;
    }
    out[0] = codec.slot();
    if (out[1] == RecordCodec.DELTA) {
      out[2] = codec.age();
      deltas.profile(Profiles.table(codec.profile()));
      out[3] = deltas.code(c, out[2], baseline, r[3], m);
    } else if (out[1] == RecordCodec.ABSOLUTE) {
      out[4] = codec.generation(c, r[4]);
      out[5] = codec.archetype(c, r[5]);
      out[6] = codec.owner(c, r[6]);
      codec.absolute(c, m);
    }
    return out;
  }

  private static int[] numbers(Motion m) {
    return new int[] {m.x, m.y, m.angle, m.vx, m.vy, m.omega};
  }

  @Test
  void recordsOfEveryKindComeBackAndARewoundOneLeavesNoTrace() {
    Random random = new Random(SEED);
    for (int round = 0; round < 300; round++) {
      int n = random.nextInt(60);
      int[][] records = new int[n + 1][];
      Motion[] baselines = new Motion[n];
      int[][] motions = new int[n][];
      encoder.reset(buffer, 0, buffer.length);
      writing.begin();
      int slot = -1;
      for (int i = 0; i < n; i++) {
        slot = random.nextInt(5) == 0 ? random.nextInt(65_535) : Math.min(65_534, slot + 1);
        records[i] =
            new int[] {
              slot,
              random.nextInt(3) > 0 ? RecordCodec.DELTA : random.nextInt(4),
              1 + random.nextInt(63),
              random.nextInt(3),
              random.nextInt(256),
              random.nextInt(random.nextBoolean() ? 64 : 65_536),
              random.nextInt(257) - 1,
              (round + random.nextInt(4) / 3) % Profiles.COUNT
            };
        baselines[i] = motion(random);
        Motion m = motion(random);
        if (random.nextInt(4) == 0) {
          m.clear();
        } else if (records[i][3] == Predictor.STOPS && records[i][1] == RecordCodec.DELTA) {
          m.vx = 0;
          m.vy = 0;
          m.omega = 0;
        }
        encoder.mark();
        writing.mark();
        Motion lost = motion(random);
        record(writing, encoder, new int[] {random.nextInt(65_535), 0, 7, 1, 0, 0, 0, 0}, m, lost);
        encoder.rewind();
        writing.rewind();
        motions[i] = numbers(m);
        int[] kept = record(writing, encoder, records[i], baselines[i], m);
        assertArrayEquals(records[i], kept);
      }
      writing.head(encoder, RecordCodec.END, 0, 0, 0);
      int bits = encoder.bits();
      int length = encoder.finish();
      assertTrue(length <= bits / 8 + 1, length + " bytes of " + bits + " bits");
      decoder.reset(Arrays.copyOf(buffer, length), 0, length);
      reading.begin();
      for (int i = 0; i < n; i++) {
        Motion m = new Motion();
        int[] read = record(reading, decoder, new int[8], baselines[i], m);
        assertEquals(records[i][0], read[0], "seed " + SEED + " round " + round);
        assertEquals(records[i][1], read[1]);
        boolean delta = read[1] == RecordCodec.DELTA;
        if (delta || read[1] == RecordCodec.ABSOLUTE) {
          int from = delta ? 2 : 4;
          int to = delta ? 4 : 7;
          assertArrayEquals(
              Arrays.copyOfRange(records[i], from, to), Arrays.copyOfRange(read, from, to));
          assertArrayEquals(motions[i], numbers(m));
        }
      }
      assertEquals(RecordCodec.END, reading.head(decoder, 0, 0, 0, 0));
      assertTrue(decoder.finished());
    }
  }

  @Test
  void fallingAndStoppingBodiesAreForeseen() {
    Predictor predictor = new Predictor(60);
    predictor.gravity(0, -10);
    Motion before = new Motion();
    before.vx = 128;
    before.omega = 9;
    Motion after = new Motion();
    after.vx = 128;
    after.vy = -64;
    after.omega = 9;
    after.x = 103;
    after.y = -26;
    after.angle = 5;
    assertEquals(Predictor.FALLS, predictor.way(before, after, 6), "1 m/s slower after 100 ms");
    Motion residual = new Motion();
    residual.setResidual(predictor, before, after, Predictor.FALLS, 6);
    assertArrayEquals(new int[] {1, 0, 0, 0, 0, 0}, numbers(residual));
    after.clear();
    assertEquals(Predictor.STOPS, predictor.way(before, after, 6));
    residual.setResidual(predictor, before, after, Predictor.STOPS, 6);
    assertEquals(0, residual.vx | residual.vy | residual.omega);
    before.addResidual(predictor, residual, Predictor.STOPS, 6);
    assertArrayEquals(numbers(after), numbers(before));
    assertEquals(Predictor.GOES_ON, predictor.way(before, after, 6));
  }
}
