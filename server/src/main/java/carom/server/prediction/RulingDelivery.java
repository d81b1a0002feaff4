package carom.server.prediction;

import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.exact.NearCodec;
import carom.net.snapshot.exact.NearState;
import carom.physics.rows.BodyRow;
import carom.sim.ruling.Ruling;

/**
 * Brings rulings, which are what the game's rules did to near bodies by themselves, to the client.
 * A ruling is due until a snapshot with it is sent, once more on a line that loses datagrams, and
 * again when all snapshots with it are lost.
 *
 * <p>The room's thread; allocates only to grow.
 */
final class RulingDelivery {
  /** Most rulings that wait or are in flight. */
  static final int MOST = 256;

  /**
   * Rulings of one snapshot take at most this much, bits. A tick with more is told by an exact
   * update instead.
   */
  static final int MOST_BITS = 6_000;

  /** A ruling that is older is of no use: the client forgets its tick, ticks. */
  private static final int MAX_AGE = 60;

  /** A snapshot counts as lost when one so many ticks younger has arrived. */
  private static final int OVERTAKEN_TICKS = 3;

  /** One ruling and what became of it. */
  private static final class Item {
    final Ruling ruling = new Ruling();

    /** Copies that are still to be sent. */
    int due;

    /** True if the snapshot being prepared has the ruling. */
    boolean inPart;

    /** Ticks of the last two snapshots with it; -1 for none in flight. */
    int firstSent;

    int lastSent;
    boolean wasLost;
  }

  private final Item[] items = new Item[MOST];
  private int count;

  /** Returns how many bits a ruling takes at most. */
  static int bits(Ruling ruling) {
    return NearCodec.rulingBits(ruling.mask, ruling.joint != Ruling.BODY);
  }

  /** Forgets all. */
  void clear() {
    count = 0;
  }

  /**
   * Adds a ruling.
   *
   * @param copies in how many snapshots it is sent
   * @return false if there is no room
   */
  boolean add(Ruling ruling, int copies) {
    if (count == MOST) {
      return false;
    }
    if (items[count] == null) {
      items[count] = new Item();
    }
    Item item = items[count++];
    item.ruling.set(ruling);
    item.due = copies;
    item.inPart = false;
    item.firstSent = -1;
    item.lastSent = -1;
    item.wasLost = false;
    return true;
  }

  /**
   * Returns whether the client lacks a ruling, because there was no room or the snapshots with it
   * were lost.
   */
  boolean isBehind() {
    for (int i = 0; i < count; i++) {
      if (items[i].wasLost || items[i].lastSent < 0) {
        return true;
      }
    }
    return false;
  }

  /**
   * Prepares a snapshot: writes those that are due, the oldest first, as far as there is room.
   *
   * @param tick of the snapshot
   * @param members the list that places refer to
   * @param room what they may take, bits
   * @param out has the list
   * @return what they take, bits
   */
  int write(int tick, KeyList members, int room, NearState out) {
    dropOld(tick);
    int most = Math.min(room, MOST_BITS);
    int used = 0;
    for (int i = 0; i < count; i++) {
      Item item = items[i];
      item.inPart = false;
      if (item.due == 0 || out.rulings() == NearState.MAX_RULINGS) {
        continue;
      }
      int place = members.find(item.ruling.key, 0);
      int bits = bits(item.ruling);
      if (place < 0 || used + bits > most) {
        continue;
      }
      used += bits;
      item.inPart = true;
      int moment = item.ruling.moment.ordinal();
      out.addRuling(place, tick - item.ruling.tick, moment, item.ruling.mask);
      out.setRulingJoint(item.ruling.joint);
      for (int word = 0; word < Ruling.WORDS; word++) {
        if ((item.ruling.mask & 1 << word) != 0) {
          out.setRulingWord(word, item.ruling.row[BodyRow.MOTION + word]);
        }
      }
    }
    return used;
  }

  /** Notes that the snapshot prepared last was sent at a tick. */
  void sent(int tick) {
    for (int i = 0; i < count; i++) {
      Item item = items[i];
      if (item.inPart) {
        item.inPart = false;
        item.due--;
        item.firstSent = item.lastSent;
        item.lastSent = tick;
      }
    }
  }

  /** Looks which have arrived, and which are lost and due again. */
  void acknowledge(SnapshotEncoder encoder) {
    int kept = 0;
    for (int i = 0; i < count; i++) {
      Item item = items[i];
      if (encoder.hasAckedOwn(item.firstSent) || encoder.hasAckedOwn(item.lastSent)) {
        continue;
      }
      if (item.due == 0 && encoder.ownAckedTick() - item.lastSent >= OVERTAKEN_TICKS) {
        item.due = 1;
        item.wasLost = true;
      }
      keep(i, kept++);
    }
    count = kept;
  }

  private void dropOld(int tick) {
    int kept = 0;
    for (int i = 0; i < count; i++) {
      if (tick - items[i].ruling.tick <= MAX_AGE) {
        keep(i, kept++);
      }
    }
    count = kept;
  }

  private void keep(int from, int to) {
    Item item = items[from];
    items[from] = items[to];
    items[to] = item;
  }
}
