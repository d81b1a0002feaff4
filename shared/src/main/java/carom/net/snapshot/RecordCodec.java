package carom.net.snapshot;

import carom.net.codec.BitReader;
import carom.net.codec.BitWriter;
import carom.net.codec.Bits;
import carom.net.codec.ResidualCode;

/**
 * The forms of which an entity's record is made: each as a pair of write and read that mirror each
 * other line by line. {@code docs/PROTOCOL.md} has the same as tables.
 */
final class RecordCodec {

  /** Kinds of records, in order of their codes. */
  static final int DELTA = 0;

  static final int ABSOLUTE = 1;
  static final int GONE = 2;
  static final int OUT_OF_SIGHT = 3;

  /** Answer of {@link #readSlot} at the end of the records. */
  static final int END = -1;

  static final int END_BITS = 4;

  /** No record is shorter: next slot, delta, same age, as predicted. */
  static final int MIN_RECORD_BITS = 4;

  static final int AGE_BITS = 6;

  private static final int GAP_1_BITS = 4;
  private static final int GAP_2_BITS = 8;
  private static final int SLOT_BITS = 16;
  private static final int SHORT_ARCHETYPE_BITS = 6;

  /** One set of widths for the six residuals. */
  private record Widths(
      ResidualCode velocity, ResidualCode omega, ResidualCode position, ResidualCode angle) {

    int size(Motion residual) {
      return velocity.size(residual.vx)
          + velocity.size(residual.vy)
          + omega.size(residual.omega)
          + position.size(residual.x)
          + position.size(residual.y)
          + angle.size(residual.angle);
    }
  }

  // Each record takes the cheaper of two sets. Found by clustering the residuals of four made-up
  // scenes (top-down, bouncing, frictionless,
  // piled discs; 200 bodies, baseline 100 ms old): one set 41.6 bits a record, two 40.2, four 40.3,
  // eight 40.4.
  private static final Widths CALM =
      new Widths(
          new ResidualCode(3, 5, 7),
          new ResidualCode(3, 6, 7),
          new ResidualCode(1, 6, 10),
          new ResidualCode(1, 3, 5));
  private static final Widths HIT =
      new Widths(
          new ResidualCode(6, 7, 10),
          new ResidualCode(6, 6, 8),
          new ResidualCode(6, 8, 9),
          new ResidualCode(3, 4, 6));
  private static final Motion NO_RESIDUAL = new Motion();

  private RecordCodec() {}

  /** Slots mostly ascend within a datagram; {@code previous} is -1 before the first. */
  static void writeSlot(BitWriter w, int previous, int slot) {
    int gap = slot - previous - 1;
    if (gap == 0) {
      w.write(0, 1);
    } else if (gap > 0 && gap <= 1 << GAP_1_BITS) {
      w.write(0b01 | (gap - 1) << 2, 2 + GAP_1_BITS);
    } else if (gap > 0 && gap <= (1 << GAP_1_BITS) + (1 << GAP_2_BITS)) {
      w.write(0b011 | (gap - 1 - (1 << GAP_1_BITS)) << 3, 3 + GAP_2_BITS);
    } else {
      w.write(0b0111 | slot << 4, 4 + SLOT_BITS);
    }
  }

  static void writeEnd(BitWriter w) {
    w.write(0b1111, END_BITS);
  }

  static int readSlot(BitReader r, int previous) {
    if (!r.readBit()) {
      return previous + 1;
    }
    if (!r.readBit()) {
      return previous + 2 + r.read(GAP_1_BITS);
    }
    if (!r.readBit()) {
      return previous + 2 + (1 << GAP_1_BITS) + r.read(GAP_2_BITS);
    }
    return r.readBit() ? END : r.read(SLOT_BITS);
  }

  static void writeKind(BitWriter w, int kind) {
    switch (kind) {
      case DELTA -> w.write(0, 1);
      case ABSOLUTE -> w.write(0b01, 2);
      case GONE -> w.write(0b011, 3);
      default -> w.write(0b111, 3);
    }
  }

  static int readKind(BitReader r) {
    if (!r.readBit()) {
      return DELTA;
    }
    if (!r.readBit()) {
      return ABSOLUTE;
    }
    return r.readBit() ? OUT_OF_SIGHT : GONE;
  }

  static void writeAge(BitWriter w, int previousAge, int age) {
    if (age == previousAge) {
      w.write(1, 1);
    } else {
      w.write(age << 1, 1 + AGE_BITS);
    }
  }

  static int readAge(BitReader r, int previousAge) {
    return r.readBit() ? previousAge : r.read(AGE_BITS);
  }

  static void writeResidual(BitWriter w, Motion residual) {
    w.write(!residual.isZero());
    if (residual.isZero()) {
      return;
    }
    boolean hit = HIT.size(residual) < CALM.size(residual);
    w.write(hit);
    Widths widths = hit ? HIT : CALM;
    widths.velocity.write(w, residual.vx);
    widths.velocity.write(w, residual.vy);
    widths.omega.write(w, residual.omega);
    widths.position.write(w, residual.x);
    widths.position.write(w, residual.y);
    widths.angle.write(w, residual.angle);
  }

  static void readResidual(BitReader r, Motion residual) {
    if (!r.readBit()) {
      residual.set(NO_RESIDUAL);
      return;
    }
    Widths widths = r.readBit() ? HIT : CALM;
    residual.vx = widths.velocity.read(r);
    residual.vy = widths.velocity.read(r);
    residual.omega = widths.omega.read(r);
    residual.x = widths.position.read(r);
    residual.y = widths.position.read(r);
    residual.angle = widths.angle.read(r);
  }

  static void writeIdentity(BitWriter w, int generation, int archetype, int owner) {
    w.write(generation, 8);
    boolean wide = archetype >= 1 << SHORT_ARCHETYPE_BITS;
    w.write(wide);
    w.write(archetype, wide ? 16 : SHORT_ARCHETYPE_BITS);
    w.write(owner >= 0);
    if (owner >= 0) {
      w.write(owner, 8);
    }
  }

  static int readArchetype(BitReader r) {
    return r.readBit() ? r.read(16) : r.read(SHORT_ARCHETYPE_BITS);
  }

  static int readOwner(BitReader r) {
    return r.readBit() ? r.read(8) : -1;
  }

  static void writeAbsolute(BitWriter w, Motion motion) {
    Bits.writeSized(w, motion.x);
    Bits.writeSized(w, motion.y);
    w.write(motion.angle, 10);
    boolean moving = (motion.vx | motion.vy | motion.omega) != 0;
    w.write(moving);
    if (moving) {
      Bits.writeSized(w, motion.vx);
      Bits.writeSized(w, motion.vy);
      Bits.writeSized(w, motion.omega);
    }
  }

  static void readAbsolute(BitReader r, Motion motion) {
    motion.x = Bits.readSized(r);
    motion.y = Bits.readSized(r);
    motion.angle = r.read(10);
    boolean moving = r.readBit();
    motion.vx = moving ? Bits.readSized(r) : 0;
    motion.vy = moving ? Bits.readSized(r) : 0;
    motion.omega = moving ? Bits.readSized(r) : 0;
  }
}
