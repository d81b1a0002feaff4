package carom.net.transport;

import carom.net.protocol.ProtocolLimits;
import java.util.function.LongSupplier;
import java.util.function.ToIntFunction;

/**
 * Link that simulates a bad network in both directions, in the time of a given clock. Wrap the
 * client's link and leave the server's as it is. Delayed traffic moves when {@link #poll}, {@link
 * #send} or {@link #sendDatagram} is called. Reliable messages are delayed, but never lost or
 * reordered. Use it from one thread.
 *
 * <p>{@link #close} doesn't wait: it sends delayed messages at once and drops delayed datagrams.
 */
public final class ImpairedLink implements Link {

  private static final int INNER_POLL = 1_024;

  private final Link link;
  private final LongSupplier nowNs;
  private final ToIntFunction<Object> messageBytes;
  private final LinkCounters counters = new LinkCounters();
  private final ImpairedDirection out;
  private final ImpairedDirection in;
  private boolean overTcp;
  private boolean opened;
  private boolean closedHere;
  private boolean innerClosed;
  private long closedDueNs;
  private boolean closeReported;
  private long waitedNs;

  private final LinkHandler collector =
      new LinkHandler() {
        @Override
        public void message(Link from, Object message) {
          in.addMessage(message, messageBytes.applyAsInt(message), nowNs.getAsLong());
        }

        @Override
        public void datagram(Link from, byte[] bytes, int length) {
          counters.datagramsDropped.addAndGet(pass(in, bytes, 0, length));
        }

        @Override
        public void closed(Link from, String reason) {
          innerClosed = true;
          closedDueNs = in.messageDue(nowNs.getAsLong());
        }
      };

  /**
   * Wraps a link, with the same impairment in both directions. Messages take no bandwidth.
   *
   * @param link the real link; this object owns it from now on
   * @param impairment impairment of both directions, each with its own random numbers
   * @param nowNs clock in nanoseconds; virtual or {@code System::nanoTime}
   */
  public ImpairedLink(Link link, Impairment impairment, LongSupplier nowNs) {
    this(link, impairment, impairment, nowNs);
  }

  /** Wraps a link, with an impairment for each direction. Messages take no bandwidth. */
  public ImpairedLink(Link link, Impairment outgoing, Impairment incoming, LongSupplier nowNs) {
    this(link, outgoing, incoming, nowNs, message -> 0);
  }

  /**
   * Wraps a link, with an impairment for each direction and a size for messages.
   *
   * @param link the real link; this object owns it from now on
   * @param outgoing impairment of what this end sends
   * @param incoming impairment of what this end receives
   * @param nowNs clock in nanoseconds; virtual or {@code System::nanoTime}
   * @param messageBytes size of a message in bytes, which counts on a line with limited bandwidth
   */
  public ImpairedLink(
      Link link,
      Impairment outgoing,
      Impairment incoming,
      LongSupplier nowNs,
      ToIntFunction<Object> messageBytes) {
    this.link = link;
    this.nowNs = nowNs;
    this.messageBytes = messageBytes;
    out = new ImpairedDirection(outgoing, 0);
    in = new ImpairedDirection(incoming, 1);
    opened = link.state() == State.OPEN;
  }

  /**
   * Changes the impairment of both directions from now on. Traffic in flight keeps its fate, and
   * the random sequences continue.
   */
  public void impair(Impairment outgoing, Impairment incoming) {
    out.impair(outgoing);
    in.impair(incoming);
  }

  /**
   * Returns the state as this end sees it. The peer's close takes as long to arrive as the traffic
   * before it. So a link that was open stays open until {@link #poll} has reported the close.
   */
  @Override
  public State state() {
    State inner = link.state();
    opened |= inner == State.OPEN;
    return inner == State.CLOSED && opened && !closedHere && !closeReported ? State.OPEN : inner;
  }

  @Override
  public boolean send(Object message) {
    if (link.state() != State.OPEN) {
      return false;
    }
    long now = nowNs.getAsLong();
    out.addMessage(message, messageBytes.applyAsInt(message), now);
    counters.messagesOut.incrementAndGet();
    flush(now);
    return link.state() == State.OPEN;
  }

  @Override
  public boolean sendDatagram(byte[] bytes, int offset, int length) {
    if (length < 1 || length > ProtocolLimits.MAX_DATAGRAM_BYTES) {
      throw new IllegalArgumentException(
          "datagram length=" + length + " is outside 1.." + ProtocolLimits.MAX_DATAGRAM_BYTES);
    }
    if (link.state() != State.OPEN) {
      return false;
    }
    long now = nowNs.getAsLong();
    counters.datagramsOut.incrementAndGet();
    counters.datagramBytesOut.addAndGet(length);
    counters.datagramsDropped.addAndGet(pass(out, bytes, offset, length));
    flush(now);
    return true;
  }

  /**
   * Blocks UDP from now on, or lets it pass again. TCP carries the datagrams meanwhile: they arrive
   * in order, and as late as messages do.
   */
  public void blockUdp(boolean blocked) {
    overTcp = blocked;
  }

  private int pass(ImpairedDirection direction, byte[] bytes, int offset, int length) {
    long now = nowNs.getAsLong();
    if (isOverTcp()) {
      return direction.addReliably(bytes, offset, length, now);
    }
    return direction.addDatagram(bytes, offset, length, now);
  }

  @Override
  public boolean isOverTcp() {
    return overTcp || link.isOverTcp();
  }

  @Override
  public byte[] binding() {
    return link.binding();
  }

  @Override
  public String serverFingerprint() {
    return link.serverFingerprint();
  }

  @Override
  public boolean mayPass() {
    return link.mayPass();
  }

  @Override
  public int poll(LinkHandler handler, int max) {
    long now = nowNs.getAsLong();
    flush(now);
    opened |= link.state() == State.OPEN;
    if (!innerClosed) {
      link.poll(collector, INNER_POLL);
    }
    int count = 0;
    while (count < max) {
      ImpairedDirection.Delayed item = in.takeDue(now);
      if (item == null) {
        break;
      }
      count++;
      if (item.message != null) {
        counters.messagesIn.incrementAndGet();
        handler.message(this, item.message);
      } else {
        counters.datagramsIn.incrementAndGet();
        counters.datagramBytesIn.addAndGet(item.length);
        waitedNs = now - item.dueNs;
        handler.datagram(this, item.bytes, item.length);
      }
      in.recycle(item);
    }
    if (innerClosed && !closeReported && now - closedDueNs >= 0 && !in.hasMessages()) {
      closeReported = true;
      in.clear();
      handler.closed(this, link.closeReason());
    }
    return count;
  }

  @Override
  public long waitedNs() {
    return waitedNs;
  }

  private void flush(long now) {
    for (ImpairedDirection.Delayed item; (item = out.takeDue(now)) != null; out.recycle(item)) {
      pass(item);
    }
  }

  private void pass(ImpairedDirection.Delayed item) {
    if (item.message != null) {
      link.send(item.message);
    } else {
      link.sendDatagram(item.bytes, 0, item.length);
    }
  }

  @Override
  public void close(String reason) {
    closedHere = true;
    for (ImpairedDirection.Delayed item; (item = out.takeMessage()) != null; ) {
      link.send(item.message);
    }
    out.clear();
    link.close(reason);
  }

  @Override
  public String remote() {
    return link.remote();
  }

  @Override
  public String closeReason() {
    return state() == State.CLOSED ? link.closeReason() : "";
  }

  /**
   * Returns the counters at this end of the bad network. "Out" counts what was handed to it, "in"
   * what came out of it, and "dropped" what it lost in both directions. The bytes of messages are
   * not known here and stay 0.
   */
  @Override
  public LinkCounters counters() {
    return counters;
  }
}
