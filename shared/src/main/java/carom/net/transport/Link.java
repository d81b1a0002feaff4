package carom.net.transport;

/**
 * One end of a connection: a reliable, ordered stream of messages and a stream of datagrams that
 * may get lost, doubled and reordered. Nothing here throws because of what the peer does.
 *
 * <p>Sending is allowed from any thread. {@link #poll} belongs to the owner's thread; what arrives
 * waits in a bounded inbox until then, and what doesn't fit is dropped (datagrams) or closes the
 * link (messages).
 */
public interface Link {

  /** A link's life; it only moves down this list. */
  enum State {
    /** Not yet usable: sends are refused. */
    CONNECTING,
    /** Usable. */
    OPEN,
    /** Over; what arrived before can still be polled. */
    CLOSED
  }

  /** The present state; may change at any time by another thread. */
  State state();

  /**
   * Sends a message reliably and in order.
   *
   * @param message one that the transport's codec knows, or a {@link Broadcast} of one
   * @return false when the link is not open, or the peer doesn't take its messages (the link is
   *     then closed)
   * @throws IllegalArgumentException when the codec can't encode the message: a bug of the caller
   */
  boolean send(Object message);

  /**
   * Sends a datagram; it may never arrive. The bytes are copied before this returns.
   *
   * @param length 1..1,200
   * @return false when the link is not open or the datagram was dropped right here
   * @throws IllegalArgumentException when the length is outside the range
   */
  boolean sendDatagram(byte[] bytes, int offset, int length);

  /**
   * Hands what has arrived to a handler, in order of arrival, on the calling thread. After the link
   * has closed and its inbox is empty, {@link LinkHandler#closed} is called exactly once.
   *
   * @param max most messages and datagrams to hand over in this call
   * @return how many were handed over
   */
  int poll(LinkHandler handler, int max);

  /**
   * How long the datagram that is being handed over waited for {@link #poll}, nanoseconds, so that
   * a handler knows when it arrived. Only within {@link LinkHandler#datagram}; 0 where it isn't
   * measured.
   */
  default long waitedNs() {
    return 0;
  }

  /**
   * Closes the link; messages sent before are still delivered if the transport can. Closing twice
   * does nothing.
   *
   * @param reason for logs, kept as {@link #closeReason} on this side
   */
  void close(String reason);

  /** The peer, for logs: address and port, or a name. */
  String remote();

  /** Why the link closed, or an empty string while it hasn't. */
  String closeReason();

  /** This link's live counters. */
  LinkCounters counters();
}
