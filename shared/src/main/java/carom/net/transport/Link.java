package carom.net.transport;

import java.util.function.BooleanSupplier;

/**
 * One end of a connection: a reliable, ordered stream of messages and a stream of datagrams that
 * may be lost, duplicated or reordered. Nothing that the peer does makes these methods throw.
 *
 * <p>Any thread may send. Only the owner's thread may call {@link #poll}. Until then, arrivals wait
 * in a bounded inbox; overflow drops a datagram and closes the link for a message.
 */
public interface Link {

  /** State of a link. It only moves down this list. */
  enum State {
    /** The link isn't usable yet and refuses to send. */
    CONNECTING,
    /** The link is usable. */
    OPEN,
    /** The link is closed. What arrived before can still be polled. */
    CLOSED
  }

  /** Returns the present state, which another thread may change at any time. */
  State state();

  /**
   * Sends a message reliably and in order.
   *
   * @param message a message that the transport's codec knows, or a {@link Broadcast} of one
   * @return false when the link is not open, or when it closes now because the peer doesn't take
   *     its messages
   * @throws IllegalArgumentException when the codec can't encode the message, which is a bug of the
   *     caller
   */
  boolean send(Object message);

  /**
   * Sends a datagram, which may never arrive. The bytes are copied before this returns.
   *
   * @param length 1..{@link carom.net.protocol.ProtocolLimits#MAX_DATAGRAM_BYTES}
   * @return false when the link is not open or this end dropped the datagram
   * @throws IllegalArgumentException when the length is outside the range
   */
  boolean sendDatagram(byte[] bytes, int offset, int length);

  /**
   * Passes arrivals to a handler, in order of arrival, on the calling thread. When the link has
   * closed and its inbox is empty, it calls {@link LinkHandler#closed} exactly once.
   *
   * @param max largest number of messages and datagrams to pass in this call
   * @return how many were passed
   */
  int poll(LinkHandler handler, int max);

  /**
   * Returns how long the current datagram waited for {@link #poll} in nanoseconds, so that a
   * handler knows when it arrived. It is valid only within {@link LinkHandler#datagram}, and 0
   * where it isn't measured.
   */
  default long waitedNs() {
    return 0;
  }

  /**
   * Closes the link. Messages sent before are still delivered if the transport can. A second call
   * does nothing.
   *
   * @param reason reason for logs, which {@link #closeReason} returns on this side
   */
  void close(String reason);

  /**
   * Returns whether this end sends its datagrams over TCP now, because UDP is blocked. They then
   * arrive in order, and one that would wait behind a stall is dropped here.
   */
  default boolean isOverTcp() {
    return false;
  }

  /**
   * Returns whether the reason for which this link never opened may be over in a moment: the server
   * was busy, or the line slow. An unknown name or a closed port stays so.
   */
  default boolean mayPass() {
    return false;
  }

  /**
   * Returns whether others on the way can read what the peer says, so that a join token that it
   * shows must not count again.
   */
  default boolean isPlainText() {
    return false;
  }

  /**
   * Returns a link that sends only while a condition holds, and drops everything else: this link
   * from then on, or one in front of it. It takes the place of an earlier one.
   *
   * @param condition asked before each message and datagram, by any thread that sends
   */
  default Link sendingWhile(BooleanSupplier condition) {
    return new GuardedLink(this, condition);
  }

  /** The doors by which clients come to a server. Each has an address of its own. */
  enum Door {
    /** Carom's own clients, which follow {@link carom.net.protocol.ServerMessage.Move}. */
    OWN,
    /** The play port: WebSocket. */
    PLAY,
    /** Stock KryoNet. */
    PLAIN
  }

  /** Returns the door by which the client has come, and by which it goes to another server. */
  default Door door() {
    return Door.OWN;
  }

  /**
   * Returns the fingerprint of the key that the server at the other end has proven, or an empty
   * string at a server's end, without encryption, and before the link is open.
   */
  default String serverFingerprint() {
    return "";
  }

  /**
   * Returns bytes that both ends of this link have, and no other link has: what its handshake came
   * to. They are null where there is no such handshake, and before the link is open.
   */
  default byte[] binding() {
    return null;
  }

  /** Returns the peer's address and port, or its name, for logs. */
  String remote();

  /** Returns why the link closed, or an empty string while it is open. */
  String closeReason();

  /** Returns the live counters of this link. */
  LinkCounters counters();
}
