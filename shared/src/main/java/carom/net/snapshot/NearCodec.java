package carom.net.snapshot;

import carom.net.codec.BitReader;
import carom.net.codec.BitWriter;
import carom.net.codec.Bits;

/** What is near, in bits. Pairs of write and read that mirror each other. */
final class NearCodec {
  private static final int COUNT_BITS = 6;
  private static final int KEY_BITS = 24;
  private static final int ROW_BITS = 9;
  private static final int PARTS_BITS = 20;
  private static final int POINTS_BITS = 16;

  private NearCodec() {}

  /** Writes who is near, against an acked list, and a part of an update. */
  static void write(BitWriter w, NearState baseline, NearState near) {
    w.write(near.present);
    if (!near.present) {
      return;
    }
    boolean same = near.sameList(baseline);
    w.write(!same);
    if (!same) {
      writeList(w, baseline, near);
    }
    w.write(near.hash, 32);
    w.write(near.updating);
    if (near.updating) {
      writePart(w, near);
    }
  }

  static void read(BitReader r, NearState baseline, NearState near) {
    near.clear();
    if (!r.readBit()) {
      return;
    }
    if (r.readBit()) {
      readList(r, baseline, near);
    } else {
      near.setList(baseline);
    }
    near.present = true;
    near.hash = r.read(32);
    if (r.readBit()) {
      readPart(r, near);
    }
  }

  private static void writeList(BitWriter w, NearState baseline, NearState near) {
    long added = near.count == 0 ? 0 : -1L >>> (64 - near.count);
    int from = 0;
    for (int i = 0; i < baseline.count; i++) {
      int at = find(near, baseline.key(i), from);
      w.write(at >= 0);
      if (at >= 0) {
        added &= ~(1L << at);
        from = at + 1;
      }
    }
    w.write(Long.bitCount(added), COUNT_BITS);
    for (long rest = added; rest != 0; rest &= rest - 1) {
      int at = Long.numberOfTrailingZeros(rest);
      w.write(at, COUNT_BITS);
      w.write(near.key(at), KEY_BITS);
    }
  }

  private static int find(NearState near, int key, int from) {
    for (int i = from; i < near.count; i++) {
      if (near.key(i) == key) {
        return i;
      }
    }
    return -1;
  }

  private static void readList(BitReader r, NearState baseline, NearState near) {
    long kept = 0;
    for (int i = 0; i < baseline.count; i++) {
      kept |= r.readBit() ? 1L << i : 0;
    }
    for (int added = r.read(COUNT_BITS); added > 0; added--) {
      int at = r.read(COUNT_BITS);
      int key = r.read(KEY_BITS);
      for (; near.count < at && kept != 0; kept &= kept - 1) {
        put(near, baseline.key(Long.numberOfTrailingZeros(kept)));
      }
      put(near, key);
    }
    for (; kept != 0; kept &= kept - 1) {
      put(near, baseline.key(Long.numberOfTrailingZeros(kept)));
    }
  }

  private static void put(NearState near, int key) {
    if (near.count < NearState.MAX_ENTITIES) {
      near.add(key);
    }
  }

  private static void writePart(BitWriter w, NearState near) {
    w.write(near.age, RecordCodec.AGE_BITS);
    for (int i = 0; i < near.count; i++) {
      w.write((near.told >>> i & 1) != 0);
    }
    w.write(near.totalRows, ROW_BITS);
    w.write(near.firstRow, ROW_BITS);
    w.write(near.partRows, COUNT_BITS);
    for (int row = 0; row < near.partRows; row++) {
      if (near.isEntity(row)) {
        for (int i = 1; i < NearState.ENTITY_INTS; i++) {
          writeInt(w, near.rows[near.rowAt(row) + i]);
        }
      } else {
        writeContact(w, near.rows, near.rowAt(row));
      }
    }
  }

  private static void readPart(BitReader r, NearState near) {
    int age = r.read(RecordCodec.AGE_BITS);
    long told = 0;
    for (int i = 0; i < near.count; i++) {
      told |= r.readBit() ? 1L << i : 0;
    }
    int total = r.read(ROW_BITS);
    near.beginPart(age, told, total, r.read(ROW_BITS));
    for (int n = r.read(COUNT_BITS); n > 0; n--) {
      int at = near.growRow();
      if (near.isEntity(near.partRows - 1)) {
        near.rows[at] = near.key(toldEntity(near, near.firstRow + near.partRows - 1));
        for (int i = 1; i < NearState.ENTITY_INTS; i++) {
          near.rows[at + i] = readInt(r);
        }
      } else {
        readContact(r, near.rows, at);
      }
    }
  }

  /** The place in the list of the n-th told entity. */
  private static int toldEntity(NearState near, int n) {
    long rest = near.told;
    for (int i = 0; i < n; i++) {
      rest &= rest - 1;
    }
    return Long.numberOfTrailingZeros(rest);
  }

  private static void writeContact(BitWriter w, int[] rows, int at) {
    writeEnd(w, rows[at]);
    writeEnd(w, rows[at + 1]);
    w.write(rows[at + 2] != 0);
    if (rows[at + 2] != 0) {
      w.write(rows[at + 2], PARTS_BITS);
    }
    w.write(rows[at + 3], POINTS_BITS);
    for (int i = 4; i < NearState.CONTACT_INTS; i++) {
      writeInt(w, rows[at + i]);
    }
  }

  private static void readContact(BitReader r, int[] rows, int at) {
    rows[at] = readEnd(r);
    rows[at + 1] = readEnd(r);
    rows[at + 2] = r.readBit() ? r.read(PARTS_BITS) : 0;
    rows[at + 3] = r.read(POINTS_BITS);
    for (int i = 4; i < NearState.CONTACT_INTS; i++) {
      rows[at + i] = readInt(r);
    }
  }

  /** A place in the list, or the slot of a static body. */
  private static void writeEnd(BitWriter w, int end) {
    w.write(end < 0);
    if (end < 0) {
      Bits.writeSized(w, ~end);
    } else {
      w.write(end, COUNT_BITS);
    }
  }

  private static int readEnd(BitReader r) {
    return r.readBit() ? ~(Bits.readSized(r) & Integer.MAX_VALUE) : r.read(COUNT_BITS);
  }

  private static void writeInt(BitWriter w, int value) {
    w.write(value != 0);
    if (value != 0) {
      w.write(value, 32);
    }
  }

  private static int readInt(BitReader r) {
    return r.readBit() ? r.read(32) : 0;
  }
}
