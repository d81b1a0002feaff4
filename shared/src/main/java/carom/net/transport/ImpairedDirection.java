package carom.net.transport;

import carom.net.protocol.ProtocolLimits;
import java.util.ArrayDeque;
import java.util.PriorityQueue;

/**
 * One direction of an {@link ImpairedLink}. It decides the fate of each datagram and holds the
 * traffic in flight.
 */
final class ImpairedDirection {

  /** Largest number of datagrams in flight; further ones are lost. */
  static final int MAX_DATAGRAMS = 8_192;

  /**
   * Longest queueing delay in front of a slow line in milliseconds, as in the buffer of a home
   * router.
   */
  static final int MAX_QUEUE_MS = 250;

  /** A message or datagram in flight. */
  static final class Delayed implements Comparable<Delayed> {
    long dueNs;
    long order;
    Object message;
    final byte[] bytes;
    int length;

    Delayed(byte[] bytes) {
      this.bytes = bytes;
    }

    @Override
    public int compareTo(Delayed other) {
      int byTime = Long.compare(dueNs - other.dueNs, 0);
      return byTime != 0 ? byTime : Long.compare(order, other.order);
    }
  }

  private static final byte[] NO_BYTES = {};
  private static final double NS_PER_MS = 1e6;
  private static final long MAX_QUEUE_NS = MAX_QUEUE_MS * 1_000_000L;
  private static final double MIN_HOLD_BACK_MS = 25;

  private final SplitMix random;
  private final PriorityQueue<Delayed> datagrams = new PriorityQueue<>();
  private final ArrayDeque<Delayed> messages = new ArrayDeque<>();
  private final ArrayDeque<Delayed> spare = new ArrayDeque<>();
  private Impairment impairment;
  private boolean inBurst;
  private boolean lineUsed;
  private long lineFreeNs;
  private boolean anyMessage;
  private boolean anyDatagram;
  private long lastMessageDueNs;
  private long lastDatagramDueNs;
  private long nextOrder;

  ImpairedDirection(Impairment impairment, int direction) {
    this.impairment = impairment;
    random = new SplitMix(impairment.seed() * 2 + direction);
  }

  void impair(Impairment next) {
    impairment = next;
    inBurst = false;
  }

  /**
   * Takes a datagram that TCP carries: it arrives, behind all that was sent before. One that would
   * wait in front of a slow line is lost before. Returns how many were lost.
   */
  int addReliably(byte[] bytes, int offset, int length, long nowNs) {
    if (datagrams.size() >= MAX_DATAGRAMS || queueNs(nowNs) > MAX_QUEUE_NS) {
      return 1;
    }
    long dueNs = messageDue(passLine(length + ProtocolLimits.DATAGRAM_OVERHEAD_BYTES, nowNs));
    put(bytes, offset, length, dueNs);
    return 0;
  }

  /** Takes a datagram. Returns how many were lost: 1 if this one never arrives, else 0. */
  int addDatagram(byte[] bytes, int offset, int length, long nowNs) {
    // Each datagram draws the same five numbers, so that a change of one condition leaves the
    // random numbers of the others unchanged.
    double loss = random.unit();
    double jitter = random.unit();
    double reorder = random.unit();
    double duplicate = random.unit();
    double duplicateJitter = random.unit();
    if (lost(loss) || datagrams.size() >= MAX_DATAGRAMS || queueNs(nowNs) > MAX_QUEUE_NS) {
      return 1;
    }
    long dueNs = passLine(length + ProtocolLimits.DATAGRAM_OVERHEAD_BYTES, nowNs) + delayNs(jitter);
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
   * Decides a loss by the two-state model of Gilbert (1960). For a mean burst length b and a loss
   * share p, the good state turns bad with probability p / (b (1 - p)), and the bad state turns
   * good with 1/b.
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

  /** Returns how long traffic that arrives now queues in front of the line, in nanoseconds. */
  private long queueNs(long nowNs) {
    return impairment.bandwidthKbit() == 0 || !lineUsed ? 0 : Math.max(0, lineFreeNs - nowNs);
  }

  /**
   * Queues bytes on the line. Returns the time in nanoseconds at which the last of them has passed.
   */
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
    Delayed item = spare.poll();
    if (item == null) {
      item = new Delayed(new byte[ProtocolLimits.MAX_DATAGRAM_BYTES]);
    }
    System.arraycopy(bytes, offset, item.bytes, 0, length);
    item.length = length;
    item.dueNs = dueNs;
    item.order = nextOrder++;
    datagrams.add(item);
  }

  /**
   * Takes a message.
   *
   * @param bytes size that the message takes on a line with limited bandwidth
   */
  void addMessage(Object message, int bytes, long nowNs) {
    Delayed item = new Delayed(NO_BYTES);
    item.message = message;
    item.dueNs = messageDue(passLine(bytes + ProtocolLimits.DATAGRAM_OVERHEAD_BYTES, nowNs));
    item.order = nextOrder++;
    messages.add(item);
  }

  /**
   * Returns the arrival time of a message sent now, in nanoseconds. It is never before that of an
   * earlier message.
   */
  long messageDue(long nowNs) {
    long dueNs = nowNs + delayNs(random.unit());
    if (anyMessage && dueNs - lastMessageDueNs < 0) {
      dueNs = lastMessageDueNs;
    }
    lastMessageDueNs = dueNs;
    anyMessage = true;
    return dueNs;
  }

  /** Removes and returns the earliest item that is due, or null if none is. */
  Delayed takeDue(long nowNs) {
    Delayed message = messages.peek();
    Delayed datagram = datagrams.peek();
    boolean messageFirst = datagram == null || (message != null && message.compareTo(datagram) < 0);
    Delayed first = messageFirst ? message : datagram;
    if (first == null || first.dueNs - nowNs > 0) {
      return null;
    }
    return messageFirst ? messages.poll() : datagrams.poll();
  }

  /** Removes and returns the next message, due or not, or null if there is none. */
  Delayed takeMessage() {
    return messages.poll();
  }

  boolean hasMessages() {
    return !messages.isEmpty();
  }

  void recycle(Delayed item) {
    if (item.message == null) {
      spare.add(item);
    }
  }

  void clear() {
    messages.clear();
    datagrams.clear();
  }
}
