package carom.net.snapshot.exact;

import carom.net.codec.BitReader;
import carom.net.codec.BitWriter;
import carom.net.snapshot.frame.FrameRing;

/**
 * What is near, in bits, but for the rows of an update, which are {@link NearRowCodec}'s. Pairs of
 * write and read that mirror each other.
 */
public final class NearCodec {
  private static final int PART_BITS = 6;
  private static final int KEY_BITS = 24;
  private static final int MAX_KEY = (1 << KEY_BITS) - 1;
  private static final int SLOT_MASK = 0xffff;
  private static final int CLOSE_BITS = 4;
  private static final int ROW_BITS = 11;

  private NearCodec() {}

  /** Writes who is near, against an acked list, and a part of an update. */
  public static void write(BitWriter w, NearState baseline, NearState near) {
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

  public static void read(BitReader r, NearState baseline, NearState near) {
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

  /**
   * The list as changes of the acked one, from front to back: the next of that stays, or goes, or
   * somebody new comes before it.
   */
  private static void writeList(BitWriter w, NearState baseline, NearState near) {
    int place = 0;
    for (int i = 0; i < baseline.count; i++) {
      int at = find(near, baseline.key(i), place);
      for (; place < at; place++) {
        writeInsert(w, near, place);
      }
      w.write(at < 0);
      if (at < 0) {
        w.write(false);
      } else {
        place++;
      }
    }
    for (; place < near.count; place++) {
      w.write(true);
      writeKey(w, before(near, place), near.key(place));
    }
    w.write(false);
  }

  private static void writeInsert(BitWriter w, NearState near, int place) {
    w.write(true);
    w.write(true);
    writeKey(w, before(near, place), near.key(place));
  }

  private static int before(NearState near, int place) {
    return place == 0 ? 0 : near.key(place - 1);
  }

  /** What {@link #writeInsert} takes for a key behind another. */
  static int insertBits(int before, int key) {
    return 3 + (isClose(before, key) ? CLOSE_BITS : KEY_BITS);
  }

  private static boolean isClose(int before, int key) {
    int step = key - before - 1;
    return step >= 0 && step < 1 << CLOSE_BITS && (before & SLOT_MASK) + step + 1 <= SLOT_MASK;
  }

  /** Bodies that were made together have slots in a row, and generations alike. */
  private static void writeKey(BitWriter w, int before, int key) {
    boolean close = isClose(before, key);
    w.write(close);
    if (close) {
      w.write(key - before - 1, CLOSE_BITS);
    } else {
      w.write(key, KEY_BITS);
    }
  }

  private static int readKey(BitReader r, int before) {
    return r.readBit() ? before + 1 + r.read(CLOSE_BITS) & MAX_KEY : r.read(KEY_BITS);
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
    int next = 0;
    while (next < baseline.count && !r.failed()) {
      if (!r.readBit()) {
        put(near, baseline.key(next++));
      } else if (!r.readBit()) {
        next++;
      } else {
        put(near, readKey(r, before(near, near.count)));
      }
    }
    while (r.readBit()) {
      put(near, readKey(r, before(near, near.count)));
    }
  }

  private static void put(NearState near, int key) {
    if (near.count < NearState.MAX_ENTITIES) {
      near.add(key);
    }
  }

  private static void writePart(BitWriter w, NearState near) {
    w.write(near.age, FrameRing.AGE_BITS);
    int told = 0;
    for (int i = 0; i < near.count; i++) {
      boolean isTold = told < near.toldCount && near.told[told] == i;
      w.write(isTold);
      told += isTold ? 1 : 0;
    }
    w.write(near.totalRows, ROW_BITS);
    w.write(near.firstRow, ROW_BITS);
    w.write(near.partRows(), PART_BITS);
  }

  private static void readPart(BitReader r, NearState near) {
    int age = r.read(FrameRing.AGE_BITS);
    near.beginPart(age, 0, 0);
    for (int i = 0; i < near.count; i++) {
      if (r.readBit()) {
        near.tell(i);
      }
    }
    near.totalRows = r.read(ROW_BITS);
    near.firstRow = r.read(ROW_BITS);
    for (int n = r.read(PART_BITS); n > 0; n--) {
      near.growRow();
    }
  }
}
