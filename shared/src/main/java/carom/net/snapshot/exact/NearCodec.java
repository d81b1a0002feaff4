package carom.net.snapshot.exact;

import carom.net.codec.BitPass;
import carom.net.snapshot.frame.FrameRing;
import carom.physics.rows.BodyRow;
import carom.physics.rows.RowKind;

/**
 * Codes the near section: the list of near entities, the hash of their state, and the header of a
 * part of an update. One description serves writing and reading. {@link NearRowCodec} codes the
 * rows of the part, which follow after all plain sections.
 */
final class NearCodec {
  private static final int PART_BITS = 6;
  private static final int PLACE_BITS = 8;
  private static final int RULING_BITS = 6;
  private static final int JOINT_BITS = 16;
  private static final int KEY_BITS = 24;
  private static final int MAX_KEY = (1 << KEY_BITS) - 1;
  private static final int SLOT_MASK = 0xffff;
  private static final int CLOSE_BITS = 4;
  private static final int ROW_BITS = 11;
  private static final RowKind[] KINDS = RowKind.values();

  private NearCodec() {}

  /**
   * Codes the section.
   *
   * @param baseline the acked list
   * @param near the section to write; a reader fills it
   */
  public static void code(BitPass c, NearState baseline, NearState near) {
    boolean present = c.flag(near.present);
    boolean changed = present && c.flag(!near.sameList(baseline));
    if (c.isReading()) {
      near.clear();
    }
    if (!present) {
      return;
    }
    if (changed) {
      list(c, baseline, near);
    } else if (c.isReading()) {
      near.setList(baseline);
    }
    near.present = true;
    near.hash = c.plain(near.hash, Integer.SIZE);
    if (c.flag(near.updating)) {
      part(c, near);
    }
    if (c.flag(near.rulings > 0)) {
      rulings(c, near);
    }
  }

  /** Codes the rulings, at least one. Those of one tick that follow each other are often alike. */
  private static void rulings(BitPass c, NearState near) {
    boolean writes = !c.isReading();
    int n = c.plain(near.rulings, RULING_BITS);
    int age = 0;
    int moment = 0;
    int mask = 0;
    for (int i = 0; i < n; i++) {
      int place = c.plain(writes ? near.rulingPlace(i) : 0, PLACE_BITS);
      if (c.flag(writes && (near.rulingAge(i) != age || near.rulingMoment(i) != moment))) {
        age = c.plain(writes ? near.rulingAge(i) : 0, FrameRing.AGE_BITS);
        moment = c.plain(writes ? near.rulingMoment(i) : 0, NearState.MOMENT_BITS);
      }
      boolean ofJoint = c.flag(writes && near.rulingJoint(i) >= 0);
      int joint = ofJoint ? c.plain(writes ? near.rulingJoint(i) : 0, JOINT_BITS) : -1;
      boolean otherMask = c.flag(writes && near.rulingMask(i) != mask);
      mask = otherMask ? c.plain(writes ? near.rulingMask(i) : 0, BodyRow.CHANGING_INTS) : mask;
      boolean same = i > 0 && !otherMask && !c.flag(writes && !near.hasSameWords(i));
      if (!c.require(place < near.count && moment < NearState.MOMENTS)) {
        return;
      }
      if (c.isReading()) {
        near.addRuling(place, age, moment, mask);
        near.setRulingJoint(joint);
      }
      for (int word = 0; word < BodyRow.CHANGING_INTS; word++) {
        if ((mask & 1 << word) != 0) {
          int bits = same ? near.rulingWord(i - 1, word) : word(c, near, i, word);
          if (c.isReading()) {
            near.setRulingWord(word, bits);
          }
        }
      }
    }
  }

  private static int word(BitPass c, NearState near, int ruling, int word) {
    return c.plain(c.isReading() ? 0 : near.rulingWord(ruling, word), Integer.SIZE);
  }

  /** Returns how many bits a ruling takes at most. */
  static int rulingBits(int mask, boolean ofJoint) {
    return PLACE_BITS
        + FrameRing.AGE_BITS
        + NearState.MOMENT_BITS
        + 5
        + (ofJoint ? JOINT_BITS : 0)
        + BodyRow.CHANGING_INTS
        + Integer.SIZE * Integer.bitCount(mask);
  }

  /**
   * Codes the list as changes of the acked one, from front to back. The next entity of the acked
   * list stays or goes, or a new entity comes before it.
   */
  private static void list(BitPass c, NearState baseline, NearState near) {
    int place = 0;
    for (int next = 0; next < baseline.count; next++) {
      int at = find(near, baseline.key(next), place);
      boolean stays = !c.flag(at != place);
      while (!stays && c.flag(at >= 0)) {
        put(c, near, place, key(c, near, place));
        place++;
        stays = !c.flag(at != place);
      }
      if (stays) {
        put(c, near, place, baseline.key(next));
        place++;
      }
    }
    for (; c.flag(place < near.count); place++) {
      put(c, near, place, key(c, near, place));
    }
  }

  /** Adds an entity to the end of the list if the pass reads. Requires that the list has room. */
  private static void put(BitPass c, NearState near, int place, int key) {
    if (c.require(place < NearState.MAX_ENTITIES) && c.isReading()) {
      near.add(key);
    }
  }

  private static int before(NearState near, int place) {
    return place == 0 ? 0 : near.key(place - 1);
  }

  /** Returns how many bits a new entity takes in the list, given the key before it. */
  static int insertBits(int before, int key) {
    return 3 + (isClose(before, key) ? CLOSE_BITS : KEY_BITS);
  }

  private static boolean isClose(int before, int key) {
    int step = key - before - 1;
    return step >= 0 && step < 1 << CLOSE_BITS && (before & SLOT_MASK) + step + 1 <= SLOT_MASK;
  }

  /**
   * Codes a key. Bodies that were made together have consecutive slots and equal generations, so a
   * key close above the one before it is short.
   */
  private static int key(BitPass c, NearState near, int place) {
    int before = before(near, Math.min(place, near.count));
    int key = place < near.count ? near.key(place) : 0;
    return c.flag(isClose(before, key))
        ? before + 1 + c.plain(key - before - 1, CLOSE_BITS) & MAX_KEY
        : c.plain(key, KEY_BITS);
  }

  private static int find(NearState near, int key, int from) {
    for (int i = from; i < near.count; i++) {
      if (near.key(i) == key) {
        return i;
      }
    }
    return -1;
  }

  /**
   * Codes the header of a part of an update: its base tick, the entities told, and which rows
   * follow.
   */
  private static void part(BitPass c, NearState near) {
    int age = c.plain(near.age, FrameRing.AGE_BITS);
    if (c.isReading()) {
      near.beginPart(age, near.counts, 0);
    }
    int told = 0;
    for (int i = 0; i < near.count; i++) {
      if (c.flag(told < near.toldCount && near.told[told] == i)) {
        if (c.isReading()) {
          near.tell(i);
        }
        told++;
      }
    }
    for (RowKind kind : KINDS) {
      if (kind != RowKind.BODY) {
        boolean any = c.flag(near.counts.get(kind) > 0);
        near.counts.set(kind, any ? c.plain(near.counts.get(kind), ROW_BITS) : 0);
      }
    }
    c.require(near.totalRows() <= NearState.MAX_ROWS);
    near.firstRow = c.plain(near.firstRow, ROW_BITS);
    int rows = c.plain(near.partRows(), PART_BITS);
    if (c.isReading()) {
      makeRows(near, rows);
    }
  }

  /**
   * Adds empty rows that {@link NearRowCodec} fills later. The key of an entity is already known
   * and set.
   */
  private static void makeRows(NearState near, int rows) {
    for (int n = 0; n < rows; n++) {
      near.growRow();
    }
  }
}
