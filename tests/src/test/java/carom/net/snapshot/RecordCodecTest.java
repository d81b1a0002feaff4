package carom.net.snapshot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.BitCoder;
import carom.net.codec.Quantizer;
import carom.net.codec.RangeDecoder;
import carom.net.codec.RangeEncoder;
import carom.net.snapshot.frame.QuantizedPose;
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
  private final DeltaCodec deltas = new DeltaCodec();
  private final Predictor predictor = new Predictor(60);
  private final byte[] buffer = new byte[1 << 16];

  private static int any(Random random, int max) {
    int sign = random.nextBoolean() ? 1 : -1;
    return sign
        * (random.nextInt(9) == 0 ? max : random.nextInt(1 << random.nextInt(25)) % (max + 1));
  }

  private static QuantizedPose pose(Random random) {
    QuantizedPose p = new QuantizedPose();
    p.x = any(random, Quantizer.MAX_POSITION);
    p.y = any(random, Quantizer.MAX_POSITION);
    p.angle = random.nextInt(Quantizer.ANGLE_STEPS);
    p.still = random.nextBoolean();
    return p;
  }

  /** One record: numbers that say what it is, and of a run what each of its slots does. */
  private static final class Item {
    final int[] head = new int[8];
    long slots;
    final Track[] tracks = new Track[Long.SIZE];
    final QuantizedPose[] residuals = new QuantizedPose[Long.SIZE];
    final int[] rested = new int[Long.SIZE];

    Item() {
      Arrays.setAll(tracks, i -> new Track());
      Arrays.setAll(residuals, i -> new QuantizedPose());
    }
  }

  // The numbers of a head: kind; word, baseline, profiles, density; or slot, generation, archetype
  // ...
  private Item any(Random random) {
    Item item = new Item();
    int[] h = item.head;
    h[0] = random.nextInt(3) > 0 ? RecordCodec.RUN : random.nextInt(4);
    if (h[0] == RecordCodec.RUN) {
      h[1] = random.nextInt(5) == 0 ? random.nextInt(1_024) : random.nextInt(4);
      int age = 1 + (random.nextBoolean() ? random.nextInt(63) : random.nextInt(2));
      int stride = 1 + random.nextInt(Baseline.MAX_STRIDE);
      h[2] = Baseline.of(age, 1 + random.nextInt(3), random.nextInt(4) > 0 ? 3 : stride);
      h[3] = random.nextInt(Profiles.COUNT);
      h[4] = random.nextBoolean() ? h[3] : random.nextInt(Profiles.COUNT);
      h[5] = random.nextInt(SlotCodec.DENSITIES);
      item.slots = random.nextInt(3) == 0 ? -1 : 1L << random.nextInt(64) | random.nextLong();
      for (int i = 0; i < Long.SIZE; i++) {
        for (int pose = 0; pose < Baseline.MOST_POSES; pose++) {
          item.tracks[i].pose(pose).set(pose(random));
        }
        predictor.study(item.tracks[i], h[2]);
        item.rested[i] = random.nextInt(Baseline.age(h[2]));
        QuantizedPose predicted = new QuantizedPose();
        predictor.predict(item.tracks[i], h[3], predicted);
        item.residuals[i].setResidual(predicted, random.nextInt(4) > 0 ? pose(random) : predicted);
      }
    } else {
      h[1] = random.nextInt(65_535);
      if (h[0] == RecordCodec.ABSOLUTE) {
        h[2] = random.nextInt(256);
        h[3] = random.nextInt(random.nextBoolean() ? 64 : 65_536);
        h[4] = random.nextInt(257) - 1;
        h[5] = random.nextInt(16);
        item.residuals[0] = pose(random);
      }
    }
    return item;
  }

  /** Codes a record; what was read goes into it, what was written stays as it was. */
  private void code(RecordCodec codec, BitCoder c, Runnable cut, Item item) {
    int[] h = item.head;
    h[0] = codec.kind(c, h[0]);
    if (h[0] == RecordCodec.RUN) {
      codec.run(c, h[1], h[2], h[3], h[4], h[5]);
      h[1] = codec.word();
      h[2] = codec.baseline();
      h[3] = codec.lowProfile();
      h[4] = codec.highProfile();
      h[5] = codec.density();
      cut.run();
      item.slots = SlotCodec.code(c, h[5], item.slots);
      cut.run();
      for (long rest = item.slots; rest != 0; rest &= rest - 1) {
        int i = Long.numberOfTrailingZeros(rest);
        deltas.profile(h[i < 32 ? 3 : 4]);
        item.rested[i] = deltas.code(c, item.tracks[i], item.residuals[i], item.rested[i]);
        cut.run();
      }
    } else if (h[0] != RecordCodec.END) {
      h[1] = codec.slot(c, h[1]);
      if (h[0] == RecordCodec.ABSOLUTE) {
        h[2] = codec.generation(c, h[2]);
        h[3] = codec.archetype(c, h[3]);
        h[4] = codec.owner(c, h[4]);
        h[5] = codec.teleports(c, h[5]);
        codec.absolute(c, item.residuals[0]);
      }
    }
  }

  private static int[] numbers(QuantizedPose p) {
    return new int[] {p.x, p.y, p.angle, p.still ? 1 : 0};
  }

  @Test
  void recordsOfEveryKindComeBackAndARewoundOneLeavesNoTrace() {
    Random random = new Random(SEED);
    Item end = new Item();
    end.head[0] = RecordCodec.END;
    for (int round = 0; round < 200; round++) {
      Item[] items = new Item[random.nextInt(30)];
      encoder.reset(buffer, 0, buffer.length);
      writing.begin();
      for (int i = 0; i < items.length; i++) {
        items[i] = any(random);
        encoder.mark();
        writing.mark();
        code(writing, encoder, encoder::cut, any(random));
        encoder.rewind();
        writing.rewind();
        code(writing, encoder, encoder::cut, items[i]);
      }
      code(writing, encoder, encoder::cut, end);
      int bits = encoder.bits();
      int length = encoder.finish();
      assertTrue(length <= bits / 8 + 1, length + " bytes of " + bits + " bits");
      decoder.reset(Arrays.copyOf(buffer, length), 0, length);
      reading.begin();
      String where = "seed " + SEED + " round " + round;
      for (Item item : items) {
        Item read = new Item();
        System.arraycopy(item.tracks, 0, read.tracks, 0, Long.SIZE);
        code(reading, decoder, decoder::cut, read);
        assertArrayEquals(item.head, read.head, where);
        assertEquals(item.slots, read.slots, where);
        for (int i = 0; i < Long.SIZE; i++) {
          if ((item.slots >>> i & 1) != 0) {
            assertArrayEquals(numbers(item.residuals[i]), numbers(read.residuals[i]), where);
            assertEquals(item.rested[i], read.rested[i], where);
          }
        }
        if (item.head[0] == RecordCodec.ABSOLUTE) {
          assertArrayEquals(numbers(item.residuals[0]), numbers(read.residuals[0]), where);
        }
      }
      assertEquals(RecordCodec.END, reading.kind(decoder, 0));
      assertTrue(decoder.finished());
    }
  }

  @Test
  void fallingBodiesArePredicted() {
    Predictor falling = new Predictor(60);
    falling.gravity(0, -10);
    Track track = new Track();
    QuantizedPose predicted = new QuantizedPose();
    int baseline = Baseline.of(6, 3, 3);
    for (int i = 0; i < 3; i++) {
      track.pose(i).set(-15 * i, fallen(-3 * i), 0, false);
    }
    falling.study(track, baseline);
    assertTrue(track.falls);
    falling.predict(track, 0, predicted);
    assertEquals(30, predicted.x);
    assertEquals(fallen(6), predicted.y);
  }

  /** Steps that a body has fallen after ticks that it began with 1 m/s upwards. */
  private static int fallen(int ticks) {
    double t = ticks / 60.0;
    return Quantizer.position((float) (t - 5 * t * t));
  }

  @Test
  void whatIsPredictedIsAPoseWhateverTheTrackIs() {
    Random random = new Random(SEED);
    Predictor falling = new Predictor(1);
    falling.gravity(-1e9f, 1e9f);
    QuantizedPose predicted = new QuantizedPose();
    for (int round = 0; round < 20_000; round++) {
      Track track = new Track();
      for (int i = 0; i < 3; i++) {
        track.pose(i).set(pose(random));
      }
      int stride = 1 + random.nextInt(Baseline.MAX_STRIDE);
      int baseline = Baseline.of(1 + random.nextInt(63), 1 + random.nextInt(3), stride);
      Predictor any = random.nextBoolean() ? falling : predictor;
      any.study(track, baseline);
      any.predict(track, random.nextInt(Profiles.COUNT), predicted);
      assertTrue(predicted.inRange(), "seed " + SEED + " round " + round);
    }
  }
}
