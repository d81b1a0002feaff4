package carom.net.snapshot.exact;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.RangeDecoder;
import carom.net.codec.RangeEncoder;
import carom.physics.rows.BodyRow;
import carom.physics.rows.ContactRow;
import carom.physics.rows.FieldRow;
import carom.physics.rows.RowCounts;
import carom.physics.rows.RowKind;
import carom.physics.rows.Rows;
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
    int[] row = new int[BodyRow.INTS];
    for (int i = BodyRow.MOTION; i < row.length; i++) {
      row[i] = number(i < BodyRow.LOADS ? 5 : 0.01f);
    }
    row[BodyRow.KEY] = random.nextInt();
    row[BodyRow.ARCHETYPE] = random.nextInt(4) == 0 ? random.nextInt(4_096) : 7;
    row[BodyRow.X] = own.motion(BodyRow.X) + (random.nextInt() >> random.nextInt(32));
    unit(row, BodyRow.COS);
    row[BodyRow.SLEEP_TIME] = random.nextBoolean() ? BodyRow.ASLEEP : row[BodyRow.SLEEP_TIME];
    if (random.nextBoolean()) {
      Arrays.fill(row, BodyRow.LOADS, BodyRow.LOADS + BodyRow.LOAD_INTS, 0);
    }
    return row;
  }

  private int[] contact() {
    int[] row = new int[ContactRow.INTS];
    for (int i = 0; i < 2; i++) {
      boolean isStatic = random.nextInt(4) == 0;
      row[ContactRow.END_A + i] =
          isStatic ? ~(random.nextInt() >>> 1 + random.nextInt(31)) : random.nextInt(256);
      row[ContactRow.ID_0 + i] =
          random.nextBoolean() ? random.nextInt(8) << 8 | random.nextInt(8) : number(1);
    }
    row[ContactRow.PARTS] = random.nextBoolean() ? 0 : random.nextInt(1 << 20);
    row[ContactRow.POINTS_AND_FLAGS] =
        random.nextBoolean() ? 1 + random.nextInt(2) : random.nextInt(1 << 16);
    unit(row, ContactRow.NORMAL_X);
    for (int i = ContactRow.NORMAL_IMPULSE_0; i < row.length; i++) {
      row[i] = number(0.1f);
    }
    if (random.nextBoolean()) {
      int fourTimes = row[ContactRow.NORMAL_IMPULSE_0] + (2 << 23);
      row[ContactRow.TOTAL_IMPULSE_0] = fourTimes + random.nextInt(9) - 4;
    }
    return row;
  }

  private int[] words() {
    int[] row = new int[FieldRow.INTS];
    row[FieldRow.PLACE] = random.nextInt(1 + random.nextInt(256));
    row[FieldRow.CHUNK] = random.nextInt(FieldRow.MAX_CHUNKS);
    for (int i = 0; i < FieldRow.WORD_INTS; i++) {
      row[FieldRow.WORDS + i] =
          random.nextBoolean() ? 0 : random.nextInt() >> random.nextInt(Integer.SIZE);
    }
    return row;
  }

  /** A part of some entities, all told, contacts, and fields. */
  private OwnState part() {
    OwnState own = new OwnState();
    own.setBody(1, 1, number(30), number(30), 1, 0, 0, 0, 0);
    NearState near = own.near();
    near.begin(random.nextLong());
    int entities = random.nextInt(ROWS / 2);
    for (int i = 0; i < entities; i++) {
      near.add(random.nextInt(1 << 24));
    }
    int contacts = random.nextInt(ROWS / 2);
    int fields = random.nextInt(4);
    RowCounts counts = new RowCounts();
    counts.set(RowKind.CONTACT, contacts);
    counts.set(RowKind.FIELDS, fields);
    near.beginPart(1, counts, 0);
    for (int i = 0; i < entities; i++) {
      near.tell(i);
    }
    for (int i = 0; i < entities; i++) {
      near.addRow(entity(own), 0);
    }
    int[] before = contact();
    for (int i = contacts; i > 0; i--) {
      int[] contact = contact();
      if (random.nextBoolean()) {
        contact[ContactRow.END_A] = before[ContactRow.END_A];
      }
      near.addRow(contact, 0);
      before = contact;
    }
    for (int i = 0; i < fields; i++) {
      near.addRow(words(), 0);
    }
    return own;
  }

  @Test
  void everyBitOfEveryRowComesBackAndTheMeterKnowsTheirSize() {
    NearMeter meter = new NearMeter();
    for (int round = 0; round < 3_000; round++) {
      OwnState own = part();
      NearState near = own.near();
      int[] expected = near.rows().ints().clone();
      encoder.reset(buffer, 0, buffer.length);
      codec.part(encoder, own);
      final int bits = encoder.bits();
      assertArrayEquals(expected, near.rows().ints(), "writing changes nothing");
      int length = encoder.finish();
      OwnState read = new OwnState();
      read.set(own);
      for (int i = 0; i < near.partRows(); i++) {
        int from = near.rows().at(i) + (near.kind(i) == RowKind.BODY ? BodyRow.MOTION : 0);
        Arrays.fill(read.near().rows().ints(), from, near.rows().at(i + 1), random.nextInt());
      }
      decoder.reset(buffer, 0, length);
      codec.part(decoder, read);
      String where = "seed " + SEED + " round " + round;
      assertTrue(decoder.finished(), where);
      meter.begin(own);
      for (int i = 0; i < near.partRows(); i++) {
        int ints = near.kind(i).ints();
        int from = near.rows().at(i);
        int[] got = Arrays.copyOfRange(read.near().rows().ints(), from, from + ints);
        assertArrayEquals(Arrays.copyOfRange(expected, from, from + ints), got, where);
        meter.add(near.kind(i), expected, from);
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
        if (near.kind(i) == RowKind.CONTACT) {
          Rows rows = near.rows();
          assertTrue(rows.get(i, ContactRow.END_A) < 256, "seed " + SEED);
          assertTrue(rows.get(i, ContactRow.END_B) < 256, "seed " + SEED);
          assertEquals(0, rows.get(i, ContactRow.PARTS) >>> 20, "seed " + SEED);
          assertEquals(0, rows.get(i, ContactRow.POINTS_AND_FLAGS) >>> 16, "seed " + SEED);
        }
      }
    }
  }

  @Test
  void aBodyAtRestOnTheGroundTakesAThirdOfItsBits() {
    OwnState own = new OwnState();
    own.setBody(1, 1, 3, 2, 1, 0, 0, 0, 0);
    int[] body = new int[BodyRow.INTS];
    body[BodyRow.X] = Float.floatToRawIntBits(4.123456f);
    body[BodyRow.Y] = Float.floatToRawIntBits(1.987654f);
    body[BodyRow.COS] = Float.floatToRawIntBits(1);
    body[BodyRow.SLEEP_TIME] = BodyRow.ASLEEP;
    int[] contact = new int[ContactRow.INTS];
    contact[ContactRow.END_A] = ~7;
    contact[ContactRow.POINTS_AND_FLAGS] = 2;
    contact[ContactRow.ID_0] = 0x201;
    contact[ContactRow.ID_1] = 0x300;
    contact[ContactRow.NORMAL_Y] = Float.floatToRawIntBits(1);
    for (int point = 0; point < 2; point++) {
      contact[ContactRow.NORMAL_IMPULSE_0 + 2 * point] = Float.floatToRawIntBits(0.02774f);
      contact[ContactRow.TANGENT_IMPULSE_0 + 2 * point] = 1 << 31;
      contact[ContactRow.TOTAL_IMPULSE_0 + point] = Float.floatToRawIntBits(4 * 0.02774f);
    }
    NearMeter meter = new NearMeter();
    meter.begin(own);
    meter.add(RowKind.BODY, body, 0);
    int bits = meter.bits();
    assertTrue(bits < 70, "bits=" + bits + " of an entity");
    meter.add(RowKind.CONTACT, contact, 0);
    assertTrue(meter.bits() - bits < 90, "bits=" + (meter.bits() - bits) + " of a contact");
  }
}
