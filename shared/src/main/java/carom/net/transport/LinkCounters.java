package carom.net.transport;

import java.util.concurrent.atomic.AtomicLong;

/** Traffic counters of a link. Any thread may read them; each value only grows. */
public final class LinkCounters {

  /** Number of datagrams sent. */
  public final AtomicLong datagramsOut = new AtomicLong();

  /** Number of datagrams passed to the handler. */
  public final AtomicLong datagramsIn = new AtomicLong();

  /** Number of payload bytes in datagrams sent. */
  public final AtomicLong datagramBytesOut = new AtomicLong();

  /** Number of payload bytes in datagrams received. */
  public final AtomicLong datagramBytesIn = new AtomicLong();

  /** Number of messages sent. */
  public final AtomicLong messagesOut = new AtomicLong();

  /** Number of messages received. */
  public final AtomicLong messagesIn = new AtomicLong();

  /** Number of payload bytes in messages sent. */
  public final AtomicLong messageBytesOut = new AtomicLong();

  /** Number of payload bytes in messages received. */
  public final AtomicLong messageBytesIn = new AtomicLong();

  /** Number of datagrams dropped on this side, by a full inbox or by the operating system. */
  public final AtomicLong datagramsDropped = new AtomicLong();

  /** Number of messages that could not be decoded. */
  public final AtomicLong malformed = new AtomicLong();

  /** Creates counters at zero. */
  public LinkCounters() {}
}
