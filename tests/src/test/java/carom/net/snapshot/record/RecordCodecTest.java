package carom.net.snapshot.record;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.BitCoder;
import carom.net.codec.Quantizer;
import carom.net.codec.RangeDecoder;
import carom.net.codec.RangeEncoder;
import carom.net.snapshot.frame.Motion;
import carom.net.snapshot.frame.Predictor;
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

  /** One record: numbers that say what it is, and of a run what each of its slots does. */
  private static final class Item {
    final int[] head = new int[8];
    long slots;
    final Motion[] baselines = new Motion[Long.SIZE];
    final Motion[] motions = new Motion[Long.SIZE];
    final int[] ways = new int[Long.SIZE];

    Item() {
      Arrays.setAll(baselines, i -> new Motion());
      Arrays.setAll(motions, i -> new Motion());
    }
  }

  // The numbers of a head: kind; word, age, profiles, density; or slot, generation, archetype ...
  private static Item any(Random random) {
    Item item = new Item();
    int[] h = item.head;
    h[0] = random.nextInt(3) > 0 ? RecordCodec.RUN : random.nextInt(4);
    if (h[0] == RecordCodec.RUN) {
      h[1] = random.nextInt(5) == 0 ? random.nextInt(1_024) : random.nextInt(4);
      h[2] = 1 + (random.nextBoolean() ? random.nextInt(63) : random.nextInt(2));
      h[3] = random.nextInt(Profiles.COUNT);
      h[4] = random.nextBoolean() ? h[3] : random.nextInt(Profiles.COUNT);
      h[5] = random.nextInt(SlotCodec.DENSITIES);
      item.slots = random.nextInt(3) == 0 ? -1 : 1L << random.nextInt(64) | random.nextLong();
      for (int i = 0; i < Long.SIZE; i++) {
        item.baselines[i] = motion(random);
        Motion m = motion(random);
        item.ways[i] = random.nextInt(3);
        if (random.nextInt(4) == 0) {
          m.clear();
        } else if (item.ways[i] == Predictor.STOPS) {
          m.vx = 0;
          m.vy = 0;
          m.omega = 0;
        }
        item.motions[i] = m;
      }
    } else {
      h[1] = random.nextInt(65_535);
      if (h[0] == RecordCodec.ABSOLUTE) {
        h[2] = random.nextInt(256);
        h[3] = random.nextInt(random.nextBoolean() ? 64 : 65_536);
        h[4] = random.nextInt(257) - 1;
        h[5] = random.nextInt(16);
        item.motions[0] = motion(random);
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
      h[2] = codec.age();
      h[3] = codec.lowProfile();
      h[4] = codec.highProfile();
      h[5] = codec.density();
      cut.run();
      item.slots = SlotCodec.code(c, h[5], item.slots);
      cut.run();
      for (long rest = item.slots; rest != 0; rest &= rest - 1) {
        int i = Long.numberOfTrailingZeros(rest);
        deltas.profile(h[i < 32 ? 3 : 4]);
        item.ways[i] = deltas.code(c, h[2], item.baselines[i], item.ways[i], item.motions[i]);
        cut.run();
      }
    } else if (h[0] != RecordCodec.END) {
      h[1] = codec.slot(c, h[1]);
      if (h[0] == RecordCodec.ABSOLUTE) {
        h[2] = codec.generation(c, h[2]);
        h[3] = codec.archetype(c, h[3]);
        h[4] = codec.owner(c, h[4]);
        h[5] = codec.teleports(c, h[5]);
        codec.absolute(c, item.motions[0]);
      }
    }
  }

  private static int[] numbers(Motion m) {
    return new int[] {m.x, m.y, m.angle, m.vx, m.vy, m.omega};
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
        System.arraycopy(item.baselines, 0, read.baselines, 0, Long.SIZE);
        code(reading, decoder, decoder::cut, read);
        assertArrayEquals(item.head, read.head, where);
        assertEquals(item.slots, read.slots, where);
        for (int i = 0; i < Long.SIZE; i++) {
          if ((item.slots >>> i & 1) != 0) {
            assertEquals(item.ways[i], read.ways[i], where);
            assertArrayEquals(numbers(item.motions[i]), numbers(read.motions[i]), where);
          }
        }
        if (item.head[0] == RecordCodec.ABSOLUTE) {
          assertArrayEquals(numbers(item.motions[0]), numbers(read.motions[0]), where);
        }
      }
      assertEquals(RecordCodec.END, reading.kind(decoder, 0));
      assertTrue(decoder.finished());
    }
  }

  @Test
  void fallingAndStoppingBodiesAreForeseen() {
    Predictor predictor = new Predictor(60);
    predictor.gravity(0, -10);
    Motion before = new Motion();
    before.vx = 16;
    before.omega = 1;
    Motion after = new Motion();
    after.vx = 16;
    after.vy = -8;
    after.omega = 1;
    after.x = 103;
    after.y = -26;
    after.angle = 4;
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
