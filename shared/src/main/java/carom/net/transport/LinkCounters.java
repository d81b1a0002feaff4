package carom.net.transport;

import java.util.concurrent.atomic.AtomicLong;

/** What went through a link. Safe from any thread; each value only grows. */
public final class LinkCounters {

  /** Datagrams sent. */
  public final AtomicLong datagramsOut = new AtomicLong();

  /** Datagrams handed to the handler. */
  public final AtomicLong datagramsIn = new AtomicLong();

  /** Payload bytes of datagrams sent. */
  public final AtomicLong datagramBytesOut = new AtomicLong();

  /** Payload bytes of datagrams received. */
  public final AtomicLong datagramBytesIn = new AtomicLong();

  /** Messages sent. */
  public final AtomicLong messagesOut = new AtomicLong();

  /** Messages received. */
  public final AtomicLong messagesIn = new AtomicLong();

  /** Payload bytes of messages sent. */
  public final AtomicLong messageBytesOut = new AtomicLong();

  /** Payload bytes of messages received. */
  public final AtomicLong messageBytesIn = new AtomicLong();

  /** Datagrams dropped on this side: inbox full, or refused by the system. */
  public final AtomicLong datagramsDropped = new AtomicLong();

  /** Messages that could not be decoded. */
  public final AtomicLong malformed = new AtomicLong();

  /** Creates counters at zero. */
  public LinkCounters() {}
}
