package carom.net.transport;

import carom.net.protocol.Limits;
import java.util.function.LongSupplier;
import java.util.function.ToIntFunction;

/**
 * A bad network around any link, in both directions, in the time of a clock it is given: wrap the
 * client's link and leave the server's alone. Delayed traffic moves on when {@link #poll}, {@link
 * #send} or {@link #sendDatagram} is called. Reliable messages are delayed, never lost or
 * reordered. One thread.
 *
 * <p>{@link #close} doesn't wait: messages that were still on their way out are sent at once,
 * datagrams are forgotten.
 */
public final class ImpairedLink implements Link {

  private static final int INNER_POLL = 1_024;

  private final Link link;
  private final LongSupplier nowNs;
  private final ToIntFunction<Object> messageBytes;
  private final LinkCounters counters = new LinkCounters();
  private final Lane out;
  private final Lane in;
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
          int dropped = in.addDatagram(bytes, 0, length, nowNs.getAsLong());
          counters.datagramsDropped.addAndGet(dropped);
        }

        @Override
        public void closed(Link from, String reason) {
          innerClosed = true;
          closedDueNs = in.messageDue(nowNs.getAsLong());
        }
      };

  /**
   * Wraps a link.
   *
   * @param link the real one; owned by this from now on
   * @param impairment for both directions, each with random numbers of its own
   * @param nowNs the clock, nanoseconds; virtual or {@code System::nanoTime}
   */
  public ImpairedLink(Link link, Impairment impairment, LongSupplier nowNs) {
    this(link, impairment, impairment, nowNs);
  }

  /** Wraps a link; messages weigh nothing on a line with a bandwidth. */
  public ImpairedLink(Link link, Impairment outgoing, Impairment incoming, LongSupplier nowNs) {
    this(link, outgoing, incoming, nowNs, message -> 0);
  }

  /**
   * Wraps a link.
   *
   * @param link the real one; owned by this from now on
   * @param outgoing for what is sent
   * @param incoming for what is received
   * @param nowNs the clock, nanoseconds; virtual or {@code System::nanoTime}
   * @param messageBytes how many bytes a message weighs on a line with a bandwidth
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
    out = new Lane(outgoing, 0);
    in = new Lane(incoming, 1);
    opened = link.state() == State.OPEN;
  }

  /**
   * Changes the impairment of both directions from now on; what is on its way keeps its fate. The
   * seeds don't start again.
   */
  public void impair(Impairment outgoing, Impairment incoming) {
    out.impair(outgoing);
    in.impair(incoming);
  }

  /**
   * What is to be seen from here: the other side's close takes its time like all it sent before, so
   * a link that was open stays so until {@link #poll} has told of its end.
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
    if (length < 1 || length > Limits.MAX_DATAGRAM_BYTES) {
      throw new IllegalArgumentException(
          "datagram length=" + length + " is outside 1.." + Limits.MAX_DATAGRAM_BYTES);
    }
    if (link.state() != State.OPEN) {
      return false;
    }
    long now = nowNs.getAsLong();
    counters.datagramsOut.incrementAndGet();
    counters.datagramBytesOut.addAndGet(length);
    counters.datagramsDropped.addAndGet(out.addDatagram(bytes, offset, length, now));
    flush(now);
    return true;
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
      Lane.Item item = in.takeDue(now);
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
    for (Lane.Item item; (item = out.takeDue(now)) != null; out.recycle(item)) {
      pass(item);
    }
  }

  private void pass(Lane.Item item) {
    if (item.message != null) {
      link.send(item.message);
    } else {
      link.sendDatagram(item.bytes, 0, item.length);
    }
  }

  @Override
  public void close(String reason) {
    closedHere = true;
    for (Lane.Item item; (item = out.takeMessage()) != null; ) {
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
   * Counters at this end of the bad network: out = handed to it, in = come out of it, dropped =
   * lost in it, both directions. Bytes of messages are not known here and stay 0.
   */
  @Override
  public LinkCounters counters() {
    return counters;
  }
}
