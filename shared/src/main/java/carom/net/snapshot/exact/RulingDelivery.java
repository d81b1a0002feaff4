package carom.net.snapshot.exact;

import carom.net.snapshot.ledger.DatagramLedger;
import carom.net.snapshot.ledger.Resend;
import carom.physics.rows.BodyRow;

/**
 * Brings rulings, which are what the game's rules did to near bodies by themselves, to the client.
 * A ruling is due until a snapshot with it is sent, once more on a line that loses datagrams, and
 * again when all snapshots with it are lost.
 *
 * <p>One thread; allocates only to grow.
 */
public final class RulingDelivery implements DatagramLedger.Section {
  /** Most rulings that wait or are in flight. */
  static final int MOST = 256;

  /**
   * Rulings of one snapshot take at most this much, bits. A tick with more is told by an exact
   * update instead.
   */
  public static final int MOST_BITS = 6_000;

  private static final Resend RESEND = new Resend(1, 2, Resend.Again.WHEN_LOST);

  /** An input may have a ruling in each tick, and a client can't do without one of them. */
  private static final Resend RESEND_INPUT = new Resend(2, 3, Resend.Again.WHEN_LOST);

  /** Moment of a ruling that an input made. */
  private static final int INPUT = 1;

  /** One ruling and what became of it. */
  private static final class Item {
    int number;
    int tick;
    int moment;
    int key;
    int joint;
    int mask;
    final int[] words = new int[BodyRow.CHANGING_INTS];

    /** Copies that are still to be sent. */
    int due;

    /** Copies that are on their way. */
    int sent;

    /** True if the snapshot being prepared has the ruling. */
    boolean inPart;

    /** True if all copies were lost once. */
    boolean wasLost;
  }

  private final DatagramLedger ledger;
  private final Item[] items = new Item[MOST];
  private int count;
  private int nextNumber;

  /**
   * Creates a delivery of nothing.
   *
   * @param ledger of the datagrams that own sections are written into
   */
  public RulingDelivery(DatagramLedger ledger) {
    this.ledger = ledger;
  }

  /**
   * Returns how many bits a ruling takes at most.
   *
   * @param joint index of the joint, or negative if it is about the body
   */
  public static int bits(int mask, int joint) {
    return NearCodec.rulingBits(mask, joint >= 0);
  }

  /** Forgets all. */
  public void clear() {
    count = 0;
  }

  /**
   * Adds a ruling; for the numbers see {@link NearState#addRuling}.
   *
   * @param now present tick
   * @param tick of the ruling
   * @param key of the entity
   * @param joint index of the joint, or negative if it is about the body
   * @param row row of the body, whose changed numbers are copied
   * @return false if there is no room
   */
  public boolean add(int now, int tick, int moment, int key, int joint, int mask, int[] row) {
    if (count == MOST) {
      return false;
    }
    if (items[count] == null) {
      items[count] = new Item();
    }
    Item item = items[count++];
    item.number = nextNumber++;
    item.tick = tick;
    item.moment = moment;
    item.key = key;
    item.joint = joint;
    item.mask = mask;
    System.arraycopy(row, BodyRow.MOTION, item.words, 0, item.words.length);
    item.due = ledger.copies(moment == INPUT ? RESEND_INPUT : RESEND, now);
    item.sent = 0;
    item.inPart = false;
    item.wasLost = false;
    return true;
  }

  /**
   * Returns whether the client lacks a ruling, because there was no room or the snapshots with it
   * were lost.
   */
  public boolean isBehind() {
    for (int i = 0; i < count; i++) {
      if (items[i].wasLost || items[i].sent == 0) {
        return true;
      }
    }
    return false;
  }

  /**
   * Prepares a snapshot: writes those that are due, the oldest first, as far as there is room.
   *
   * @param tick of the snapshot
   * @param room what they may take, bits
   * @param out has the list
   * @return what they take, bits
   */
  public int write(int tick, int room, NearState out) {
    dropOld(tick);
    int most = Math.min(room, MOST_BITS);
    int used = 0;
    for (int i = 0; i < count; i++) {
      Item item = items[i];
      item.inPart = false;
      if (item.due == 0 || out.rulings() == NearState.MAX_RULINGS) {
        continue;
      }
      int place = out.find(item.key);
      int bits = bits(item.mask, item.joint);
      if (place < 0 || used + bits > most) {
        continue;
      }
      used += bits;
      item.inPart = true;
      out.addRuling(place, tick - item.tick, item.moment, item.mask);
      out.setRulingJoint(item.joint);
      for (int word = 0; word < item.words.length; word++) {
        if ((item.mask & 1 << word) != 0) {
          out.setRulingWord(word, item.words[word]);
        }
      }
    }
    return used;
  }

  /** Notes that the datagram begun last holds the rulings prepared last. */
  public void wrote() {
    for (int i = 0; i < count; i++) {
      Item item = items[i];
      if (item.inPart) {
        item.inPart = false;
        item.due--;
        item.sent++;
        ledger.append(this, item.number, 0);
      }
    }
  }

  @Override
  public void acknowledged(int tick, int number, long bits) {
    int at = find(number);
    if (at >= 0) {
      count--;
      for (int i = at; i < count; i++) {
        swap(i, i + 1);
      }
    }
  }

  @Override
  public void lost(int tick, int number, long bits) {
    int at = find(number);
    if (at < 0) {
      return;
    }
    Item item = items[at];
    item.sent--;
    if (item.sent == 0 && item.due == 0) {
      item.due = 1;
      item.wasLost = true;
    }
  }

  private int find(int number) {
    for (int i = 0; i < count; i++) {
      if (items[i].number == number) {
        return i;
      }
    }
    return -1;
  }

  private void dropOld(int tick) {
    int kept = 0;
    for (int i = 0; i < count; i++) {
      if (tick - items[i].tick <= NearState.MOST_AGE) {
        swap(i, kept++);
      }
    }
    count = kept;
  }

  private void swap(int one, int other) {
    Item item = items[one];
    items[one] = items[other];
    items[other] = item;
  }
}
