package carom.net.frame;

import carom.net.protocol.ProtocolLimits;
import carom.net.transport.Broadcast;
import carom.net.transport.Link;
import carom.net.transport.LinkCounters;
import carom.net.transport.LinkHandler;
import carom.net.transport.MessageCodec;
import java.nio.ByteBuffer;
import org.jctools.queues.atomic.MpscAtomicArrayQueue;
import org.jctools.queues.atomic.SpscAtomicArrayQueue;

/**
 * Common part of both sides' links: the state, and the bounded inbox between the network's threads,
 * which fill it, and the owner's thread, which polls it. Datagram buffers are recycled, so a steady
 * stream allocates nothing. The queues are JCTools' atomic ones because these work without {@code
 * sun.misc.Unsafe}.
 */
public abstract class FramedLink implements Link {

  /** A received datagram with its buffer and arrival time. */
  private static final class Datagram {
    private byte[] bytes = new byte[128];
    private int length;
    private long arrivedNs;
  }

  /** The way of this end's datagrams. */
  protected final DatagramPath path = new DatagramPath();

  private final MessageCodec codec;
  private final LinkCounters counters = new LinkCounters();
  private final MpscAtomicArrayQueue<Object> inbox; // the threads of TCP and UDP add to it
  private final SpscAtomicArrayQueue<Datagram> spare;
  private final int maxDatagrams;
  private volatile State state = State.CONNECTING;
  private volatile String closeReason = "";

  // guarded by this
  private int datagramsMade;
  private Datagram unused;

  // used by the owner's thread
  private boolean closedReported;
  private long waitedNs;

  /**
   * Creates a link in {@code CONNECTING}.
   *
   * @param maxMessages largest number of unread messages
   * @param maxDatagrams largest number of unread datagrams; further ones are dropped
   */
  protected FramedLink(MessageCodec codec, int maxMessages, int maxDatagrams) {
    this.codec = codec;
    this.maxDatagrams = maxDatagrams;
    inbox = new MpscAtomicArrayQueue<>(maxMessages + maxDatagrams);
    spare = new SpscAtomicArrayQueue<>(maxDatagrams);
  }

  /**
   * Writes a frame to the TCP stream. Returns false when the link can't take it, which closes the
   * link.
   */
  protected abstract boolean transmit(Frame.Payload frame);

  /** Sends a datagram. Returns false when this end dropped it. */
  protected abstract boolean transmitDatagram(byte[] bytes, int offset, int length);

  /**
   * Tells the peer and releases the sockets after the owner has closed the link.
   *
   * @param before the state in which the owner closed the link
   */
  protected abstract void disconnect(State before, String reason);

  @Override
  public final State state() {
    return state;
  }

  @Override
  public final String closeReason() {
    return closeReason;
  }

  @Override
  public final boolean isOverTcp() {
    return state == State.OPEN && path.isOverTcp(System.nanoTime());
  }

  @Override
  public final LinkCounters counters() {
    return counters;
  }

  @Override
  public final boolean send(Object message) {
    if (state != State.OPEN) {
      return false;
    }
    byte[] bytes = Broadcast.encode(codec, message);
    if (!transmit(Frame.message(bytes))) {
      return false;
    }
    counters.messagesOut.incrementAndGet();
    counters.messageBytesOut.addAndGet(bytes.length);
    return true;
  }

  @Override
  public final boolean sendDatagram(byte[] bytes, int offset, int length) {
    if (length < 1 || length > ProtocolLimits.MAX_DATAGRAM_BYTES) {
      throw new IllegalArgumentException(
          "length=" + length + " must be from 1 to " + ProtocolLimits.MAX_DATAGRAM_BYTES);
    }
    if (state != State.OPEN) {
      return false;
    }
    if (!transmitDatagram(bytes, offset, length)) {
      counters.datagramsDropped.incrementAndGet();
      return false;
    }
    counters.datagramsOut.incrementAndGet();
    counters.datagramBytesOut.addAndGet(length);
    return true;
  }

  @Override
  public final int poll(LinkHandler handler, int max) {
    if (closedReported) {
      return 0;
    }
    boolean complete =
        state
            == State.CLOSED; // read before the inbox, which then has everything from before the end
    int count = 0;
    while (count < max) {
      Object item = inbox.poll();
      if (item == null) {
        break;
      }
      count++;
      if (item instanceof Datagram datagram) {
        counters.datagramsIn.incrementAndGet();
        counters.datagramBytesIn.addAndGet(datagram.length);
        waitedNs = System.nanoTime() - datagram.arrivedNs;
        try {
          handler.datagram(this, datagram.bytes, datagram.length);
        } finally {
          spare.offer(datagram);
        }
      } else {
        handler.message(this, item);
      }
    }
    if (complete && inbox.isEmpty()) {
      closedReported = true;
      handler.closed(this, closeReason);
    }
    return count;
  }

  @Override
  public final long waitedNs() {
    return waitedNs;
  }

  @Override
  public final void close(String reason) {
    State before = state;
    if (finish(reason)) {
      disconnect(before, reason);
    }
  }

  /**
   * Changes the state from CONNECTING to OPEN. Returns false in any other state. Any thread may
   * call it.
   */
  public final synchronized boolean open() {
    if (state != State.CONNECTING) {
      return false;
    }
    state = State.OPEN;
    return true;
  }

  /**
   * Changes the state to CLOSED, which is the last one. Returns false if the link is closed
   * already; it then keeps its first reason. Any thread may call it.
   */
  public final synchronized boolean finish(String reason) {
    if (state == State.CLOSED) {
      return false;
    }
    closeReason = reason;
    state = State.CLOSED;
    return true;
  }

  /**
   * Adds a datagram's payload to the inbox, or drops it if the inbox is full. Any thread may call
   * it: datagrams come by UDP and over TCP.
   */
  public final synchronized void receiveDatagram(ByteBuffer payload, long nowNs) {
    int length = payload.remaining();
    Datagram datagram = unused != null ? unused : spare.poll();
    unused = null;
    if (datagram == null) {
      if (datagramsMade == maxDatagrams) {
        counters.datagramsDropped.incrementAndGet();
        return;
      }
      datagramsMade++;
      datagram = new Datagram();
    }
    if (datagram.bytes.length < length) {
      datagram.bytes = new byte[length <= 512 ? 512 : ProtocolLimits.MAX_DATAGRAM_BYTES];
    }
    payload.get(datagram.bytes, 0, length);
    datagram.length = length;
    datagram.arrivedNs = nowNs;
    if (!inbox.offer(datagram)) {
      unused = datagram;
      counters.datagramsDropped.incrementAndGet();
    }
  }

  /** Adds a message to the inbox. Returns false if the inbox is full. One thread may call it. */
  public final boolean receiveMessage(Object message, int bytes) {
    counters.messagesIn.incrementAndGet();
    counters.messageBytesIn.addAndGet(bytes);
    return inbox.offer(message);
  }

  @Override
  public String toString() {
    return getClass().getSimpleName() + "[" + remote() + ", " + state + "]";
  }
}
