package carom.net.transport;

import java.util.function.LongSupplier;

/**
 * A bad network around any link, in both directions, in the time of a clock it is given: wrap the
 * client's link and leave the server's alone. Delayed traffic moves on when {@link #poll}, {@link
 * #send} or {@link #sendDatagram} is called. Reliable messages are delayed, never lost or
 * reordered. One thread.
 */
public final class ImpairedLink implements Link {

  /**
   * Wraps a link.
   *
   * @param link the real one; owned by this from now on
   * @param impairment for both directions
   * @param nowNs the clock, nanoseconds; virtual or {@code System::nanoTime}
   */
  public ImpairedLink(Link link, Impairment impairment, LongSupplier nowNs) {
    this(link, impairment, impairment, nowNs);
  }

  /** Wraps a link with one impairment for what is sent and one for what is received. */
  public ImpairedLink(Link link, Impairment outgoing, Impairment incoming, LongSupplier nowNs) {}

  /** Changes the impairment of both directions from now on; what is on its way keeps its fate. */
  public void impair(Impairment outgoing, Impairment incoming) {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public State state() {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public boolean send(Object message) {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public boolean sendDatagram(byte[] bytes, int offset, int length) {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public int poll(LinkHandler handler, int max) {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public void close(String reason) {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public String remote() {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public String closeReason() {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public LinkCounters counters() {
    throw new UnsupportedOperationException("soon");
  }
}
