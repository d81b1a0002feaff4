package carom.net.snapshot.exact;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.RangeDecoder;
import carom.net.codec.RangeEncoder;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Near rows: every bit of every number comes back, and any bytes are some rows. */
final class NearRowCodecTest {
  private static final long SEED = 90_001;
  private static final int ROWS = 40;

  private final Random random = new Random(SEED);
  private final RangeEncoder encoder = new RangeEncoder();
  private final RangeDecoder decoder = new RangeDecoder();
  private final NearRowCodec codec = new NearRowCodec();
  private final byte[] buffer = new byte[1 << 14];

  /** Numbers as a simulation has them, zeros, and patterns that are no numbers. */
  private int number(float size) {
    return switch (random.nextInt(8)) {
      case 0 -> 0;
      case 1 -> 1 << 31;
      case 2 -> random.nextInt();
      case 3 -> Float.floatToRawIntBits(random.nextBoolean() ? Float.NaN : 1 / 0f);
      default -> Float.floatToRawIntBits(size * (float) random.nextGaussian());
    };
  }

  private void unit(int[] row, int at) {
    double angle =
        random.nextInt(5) * Math.PI / 4 + (random.nextBoolean() ? random.nextFloat() : 0);
    boolean odd = random.nextInt(6) == 0;
    row[at] = odd ? number(1) : Float.floatToRawIntBits((float) Math.cos(angle));
    row[at + 1] = odd ? number(1) : Float.floatToRawIntBits((float) Math.sin(angle));
  }

  private int[] entity(OwnState own) {
    int[] row = new int[NearState.ENTITY_INTS];
    for (int i = 1; i < row.length; i++) {
      row[i] = number(i < 9 ? 5 : 0.01f);
    }
    row[0] = random.nextInt();
    row[1] = own.values[0] + (random.nextInt() >> random.nextInt(32));
    unit(row, 3);
    row[8] = random.nextBoolean() ? -1 : row[8];
    if (random.nextBoolean()) {
      Arrays.fill(row, 9, row.length, 0);
    }
    return row;
  }

  private int[] contact() {
    int[] row = new int[NearState.CONTACT_INTS];
    for (int i = 0; i < 2; i++) {
      boolean isStatic = random.nextInt(4) == 0;
      row[i] = isStatic ? ~(random.nextInt() >>> 1 + random.nextInt(31)) : random.nextInt(256);
      row[4 + i] = random.nextBoolean() ? random.nextInt(8) << 8 | random.nextInt(8) : number(1);
    }
    row[2] = random.nextBoolean() ? 0 : random.nextInt(1 << 20);
    row[3] = random.nextBoolean() ? 1 + random.nextInt(2) : random.nextInt(1 << 16);
    unit(row, 6);
    for (int i = 8; i < row.length; i++) {
      row[i] = number(0.1f);
    }
    row[13] = random.nextBoolean() ? row[13] : row[8] + (2 << 23) + random.nextInt(9) - 4;
    return row;
  }

  /** A part of some entities, all told, and contacts. */
  private OwnState part() {
    OwnState own = new OwnState();
    own.setBody(1, 1, number(30), number(30), 1, 0, 0, 0, 0);
    NearState near = own.near();
    near.begin(random.nextLong());
    int entities = random.nextInt(ROWS / 2);
    for (int i = 0; i < entities; i++) {
      near.add(random.nextInt(1 << 24));
    }
    near.beginPart(1, entities + ROWS, 0);
    for (int i = 0; i < entities; i++) {
      near.tell(i);
    }
    for (int i = 0; i < entities; i++) {
      near.addRow(entity(own), 0);
    }
    int[] before = contact();
    for (int i = random.nextInt(ROWS / 2); i > 0; i--) {
      int[] contact = contact();
      contact[0] = random.nextBoolean() ? before[0] : contact[0];
      near.addRow(contact, 0);
      before = contact;
    }
    return own;
  }

  @Test
  void everyBitOfEveryRowComesBackAndTheMeterKnowsTheirSize() {
    NearMeter meter = new NearMeter();
    for (int round = 0; round < 3_000; round++) {
      OwnState own = part();
      NearState near = own.near();
      int[] expected = near.rows().clone();
      encoder.reset(buffer, 0, buffer.length);
      codec.part(encoder, own);
      final int bits = encoder.bits();
      assertArrayEquals(expected, near.rows(), "writing changes nothing");
      int length = encoder.finish();
      OwnState read = new OwnState();
      read.set(own);
      for (int i = 0; i < near.partRows(); i++) {
        int from = near.rowAt(i) + (near.isEntity(i) ? 1 : 0);
        Arrays.fill(read.near().rows(), from, near.rowAt(i + 1), random.nextInt());
      }
      decoder.reset(buffer, 0, length);
      codec.part(decoder, read);
      String where = "seed " + SEED + " round " + round;
      assertTrue(decoder.finished(), where);
      meter.begin(own);
      for (int i = 0; i < near.partRows(); i++) {
        int ints = near.isEntity(i) ? NearState.ENTITY_INTS : NearState.CONTACT_INTS;
        int from = near.rowAt(i);
        int[] got = Arrays.copyOfRange(read.near().rows(), from, from + ints);
        assertArrayEquals(Arrays.copyOfRange(expected, from, from + ints), got, where);
        meter.add(near.isEntity(i), expected, from);
      }
      assertEquals(bits, meter.bits(), 0.02 * bits + 4, where);
    }
  }

  @Test
  void anyBytesAreSomeRowsOfNumbersInTheirRanges() {
    for (int round = 0; round < 5_000; round++) {
      OwnState own = part();
      byte[] bytes = new byte[random.nextInt(200)];
      random.nextBytes(bytes);
      decoder.reset(bytes, 0, bytes.length);
      codec.part(decoder, own);
      NearState near = own.near();
      for (int i = 0; i < near.partRows(); i++) {
        int at = near.rowAt(i);
        if (!near.isEntity(i)) {
          assertTrue(near.rows()[at] < 256 && near.rows()[at + 1] < 256, "seed " + SEED);
          assertEquals(0, near.rows()[at + 2] >>> 20, "seed " + SEED);
          assertEquals(0, near.rows()[at + 3] >>> 16, "seed " + SEED);
        }
      }
    }
  }

  @Test
  void aBodyAtRestOnTheGroundTakesAThirdOfItsBits() {
    OwnState own = new OwnState();
    own.setBody(1, 1, 3, 2, 1, 0, 0, 0, 0);
    int[] body = new int[NearState.ENTITY_INTS];
    body[1] = Float.floatToRawIntBits(4.123456f);
    body[2] = Float.floatToRawIntBits(1.987654f);
    body[3] = Float.floatToRawIntBits(1);
    body[8] = -1;
    int[] contact = new int[NearState.CONTACT_INTS];
    contact[0] = ~7;
    contact[3] = 2;
    contact[4] = 0x201;
    contact[5] = 0x300;
    contact[7] = Float.floatToRawIntBits(1);
    for (int point = 0; point < 2; point++) {
      contact[8 + 2 * point] = Float.floatToRawIntBits(0.02774f);
      contact[9 + 2 * point] = 1 << 31;
      contact[13 + point] = Float.floatToRawIntBits(4 * 0.02774f);
    }
    NearMeter meter = new NearMeter();
    meter.begin(own);
    meter.add(true, body, 0);
    int bits = meter.bits();
    assertTrue(bits < 70, "bits=" + bits + " of an entity");
    meter.add(false, contact, 0);
    assertTrue(meter.bits() - bits < 90, "bits=" + (meter.bits() - bits) + " of a contact");
  }
}
