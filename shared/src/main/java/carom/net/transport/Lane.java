package carom.net.transport;

import carom.net.protocol.Limits;
import java.util.ArrayDeque;
import java.util.PriorityQueue;

/**
 * One direction of an {@link ImpairedLink}: decides each datagram's fate and holds what is on its
 * way.
 */
final class Lane {

  /** Datagrams on their way at most; more are lost. */
  static final int MAX_DATAGRAMS = 8_192;

  /** Longest wait in front of a line that is too slow, milliseconds; a home router's buffer. */
  static final int MAX_QUEUE_MS = 250;

  /** Bytes that IP and UDP add to each datagram on the line. */
  static final int HEADER_BYTES = 28;

  /** Something on its way. */
  static final class Item implements Comparable<Item> {
    long dueNs;
    long order;
    Object message;
    final byte[] bytes;
    int length;

    Item(byte[] bytes) {
      this.bytes = bytes;
    }

    @Override
    public int compareTo(Item other) {
      int byTime = Long.compare(dueNs - other.dueNs, 0);
      return byTime != 0 ? byTime : Long.compare(order, other.order);
    }
  }

  private static final byte[] NO_BYTES = {};
  private static final double NS_PER_MS = 1e6;
  private static final long MAX_QUEUE_NS = MAX_QUEUE_MS * 1_000_000L;
  private static final double MIN_HOLD_BACK_MS = 25;

  private final SplitMix random;
  private final PriorityQueue<Item> datagrams = new PriorityQueue<>();
  private final ArrayDeque<Item> messages = new ArrayDeque<>();
  private final ArrayDeque<Item> spare = new ArrayDeque<>();
  private Impairment impairment;
  private boolean inBurst;
  private boolean lineUsed;
  private long lineFreeNs;
  private boolean anyMessage;
  private boolean anyDatagram;
  private long lastMessageDueNs;
  private long lastDatagramDueNs;
  private long nextOrder;

  Lane(Impairment impairment, int direction) {
    this.impairment = impairment;
    random = new SplitMix(impairment.seed() * 2 + direction);
  }

  void impair(Impairment next) {
    impairment = next;
    inBurst = false;
  }

  /** Takes a datagram; returns how many copies were lost: 1 when it will never arrive, else 0. */
  int addDatagram(byte[] bytes, int offset, int length, long nowNs) {
    // Every datagram draws the same five numbers, so that changing one condition leaves the others'
    // dice alone.
    double loss = random.unit();
    double jitter = random.unit();
    double reorder = random.unit();
    double duplicate = random.unit();
    double duplicateJitter = random.unit();
    if (lost(loss) || datagrams.size() >= MAX_DATAGRAMS || queueNs(nowNs) > MAX_QUEUE_NS) {
      return 1;
    }
    long dueNs = passLine(length + HEADER_BYTES, nowNs) + delayNs(jitter);
    if (!impairment.jitterReorders()) {
      if (anyDatagram && dueNs - lastDatagramDueNs < 0) {
        dueNs = lastDatagramDueNs;
      }
      lastDatagramDueNs = dueNs;
      anyDatagram = true;
    }
    if (reorder * 100 < impairment.reorderPercent()) {
      dueNs += (long) (Math.max(2 * impairment.jitterMs(), MIN_HOLD_BACK_MS) * NS_PER_MS);
    }
    put(bytes, offset, length, dueNs);
    if (duplicate * 100 < impairment.duplicatePercent()) {
      put(
          bytes,
          offset,
          length,
          dueNs + (long) (duplicateJitter * impairment.jitterMs() * NS_PER_MS));
    }
    return 0;
  }

  /**
   * Two-state loss (Gilbert, 1960): with mean burst length b and loss p, good turns bad with p / (b
   * (1 - p)), bad good with 1/b.
   */
  private boolean lost(double dice) {
    double p = impairment.lossPercent() / 100;
    if (p >= 1 || impairment.burst() <= 1) {
      return dice < p;
    }
    double change = inBurst ? 1 / impairment.burst() : p / (impairment.burst() * (1 - p));
    if (dice < change) {
      inBurst = !inBurst;
    }
    return inBurst;
  }

  /** How long something that comes now waits in front of the line. */
  private long queueNs(long nowNs) {
    return impairment.bandwidthKbit() == 0 || !lineUsed ? 0 : Math.max(0, lineFreeNs - nowNs);
  }

  /** Puts bytes on the line, behind those before; returns when the last of them has passed. */
  private long passLine(int bytes, long nowNs) {
    if (impairment.bandwidthKbit() == 0) {
      return nowNs;
    }
    double bits = 8.0 * bytes;
    lineFreeNs = nowNs + queueNs(nowNs) + (long) (bits * NS_PER_MS / impairment.bandwidthKbit());
    lineUsed = true;
    return lineFreeNs;
  }

  private long delayNs(double dice) {
    double ms = impairment.latencyMs() + (2 * dice - 1) * impairment.jitterMs();
    return (long) (Math.max(0, ms) * NS_PER_MS);
  }

  private void put(byte[] bytes, int offset, int length, long dueNs) {
    Item item = spare.poll();
    if (item == null) {
      item = new Item(new byte[Limits.MAX_DATAGRAM_BYTES]);
    }
    System.arraycopy(bytes, offset, item.bytes, 0, length);
    item.length = length;
    item.dueNs = dueNs;
    item.order = nextOrder++;
    datagrams.add(item);
  }

  /**
   * @param bytes its weight on a line with a bandwidth
   */
  void addMessage(Object message, int bytes, long nowNs) {
    Item item = new Item(NO_BYTES);
    item.message = message;
    item.dueNs = messageDue(passLine(bytes + HEADER_BYTES, nowNs));
    item.order = nextOrder++;
    messages.add(item);
  }

  /** When a message that is sent now arrives: never before an earlier one. */
  long messageDue(long nowNs) {
    long dueNs = nowNs + delayNs(random.unit());
    if (anyMessage && dueNs - lastMessageDueNs < 0) {
      dueNs = lastMessageDueNs;
    }
    lastMessageDueNs = dueNs;
    anyMessage = true;
    return dueNs;
  }

  /** The earliest item that is due, taken out; null when none is. */
  Item takeDue(long nowNs) {
    Item message = messages.peek();
    Item datagram = datagrams.peek();
    boolean messageFirst = datagram == null || (message != null && message.compareTo(datagram) < 0);
    Item first = messageFirst ? message : datagram;
    if (first == null || first.dueNs - nowNs > 0) {
      return null;
    }
    return messageFirst ? messages.poll() : datagrams.poll();
  }

  /** The next message whether due or not; null when there is none. */
  Item takeMessage() {
    return messages.poll();
  }

  boolean hasMessages() {
    return !messages.isEmpty();
  }

  void recycle(Item item) {
    if (item.message == null) {
      spare.add(item);
    }
  }

  void clear() {
    messages.clear();
    datagrams.clear();
  }
}
