package carom.net.transport;

import carom.net.protocol.ProtocolLimits;
import java.util.ArrayDeque;

/** One end of an in-process connection. Both ends share one lock; handlers run outside the lock. */
final class InProcessLink implements Link {

  /**
   * Largest number of datagrams waiting in an inbox. A further one is dropped, as by a full socket
   * buffer.
   */
  static final int MAX_DATAGRAMS = 1_024;

  /** Largest number of message bytes waiting in an inbox. A message beyond it closes the link. */
  static final int MAX_MESSAGE_BYTES = 4 * 1_024 * 1_024;

  private static final class Parcel {
    final boolean datagram;
    final byte[] bytes;
    int length;

    Parcel(boolean datagram, byte[] bytes) {
      this.datagram = datagram;
      this.bytes = bytes;
      length = bytes.length;
    }
  }

  private final MessageCodec codec;
  private final String remote;
  private final String fingerprint;
  private final byte[] binding;
  private final LinkCounters counters = new LinkCounters();
  private final ArrayDeque<Parcel> inbox = new ArrayDeque<>();
  private final ArrayDeque<Parcel> spareDatagrams = new ArrayDeque<>();
  private int inboxDatagrams;
  private int inboxMessageBytes;
  private final Object lock;
  private InProcessLink peer = this;
  private volatile State state = State.OPEN;
  private volatile String closeReason = "";
  private boolean closeReported;

  InProcessLink(
      MessageCodec codec, String remote, Object lock, String fingerprint, byte[] binding) {
    this.binding = binding;
    this.fingerprint = fingerprint;
    this.lock = lock;
    this.codec = codec;
    this.remote = remote;
  }

  /** Joins two links to one connection. Both must have been created with the same lock. */
  static void join(InProcessLink a, InProcessLink b) {
    a.peer = b;
    b.peer = a;
  }

  @Override
  public State state() {
    return state;
  }

  @Override
  public byte[] binding() {
    return binding;
  }

  @Override
  public String serverFingerprint() {
    return fingerprint;
  }

  @Override
  public boolean send(Object message) {
    byte[] bytes = Broadcast.encode(codec, message);
    synchronized (lock) {
      if (state != State.OPEN) {
        return false;
      }
      if (peer.inboxMessageBytes + bytes.length > MAX_MESSAGE_BYTES) {
        closeBoth(
            "the other side doesn't take its messages: "
                + peer.inboxMessageBytes
                + " bytes wait, limit="
                + MAX_MESSAGE_BYTES);
        return false;
      }
      peer.inbox.add(new Parcel(false, bytes));
      peer.inboxMessageBytes += bytes.length;
    }
    counters.messagesOut.incrementAndGet();
    counters.messageBytesOut.addAndGet(bytes.length);
    return true;
  }

  @Override
  public boolean sendDatagram(byte[] bytes, int offset, int length) {
    checkLength(length);
    synchronized (lock) {
      if (state != State.OPEN) {
        return false;
      }
      counters.datagramsOut.incrementAndGet();
      counters.datagramBytesOut.addAndGet(length);
      if (peer.inboxDatagrams >= MAX_DATAGRAMS) {
        peer.counters.datagramsDropped.incrementAndGet();
        return true;
      }
      Parcel item = peer.spareDatagrams.poll();
      if (item == null) {
        item = new Parcel(true, new byte[ProtocolLimits.MAX_DATAGRAM_BYTES]);
      }
      System.arraycopy(bytes, offset, item.bytes, 0, length);
      item.length = length;
      peer.inbox.add(item);
      peer.inboxDatagrams++;
      return true;
    }
  }

  static void checkLength(int length) {
    if (length < 1 || length > ProtocolLimits.MAX_DATAGRAM_BYTES) {
      throw new IllegalArgumentException(
          "datagram length=" + length + " is outside 1.." + ProtocolLimits.MAX_DATAGRAM_BYTES);
    }
  }

  @Override
  public int poll(LinkHandler handler, int max) {
    int count = 0;
    while (count < max) {
      Parcel item;
      synchronized (lock) {
        item = inbox.poll();
        if (item == null) {
          break;
        }
        if (item.datagram) {
          inboxDatagrams--;
        } else {
          inboxMessageBytes -= item.length;
        }
      }
      count++;
      hand(item, handler);
    }
    reportClose(handler);
    return count;
  }

  private void hand(Parcel item, LinkHandler handler) {
    if (item.datagram) {
      counters.datagramsIn.incrementAndGet();
      counters.datagramBytesIn.addAndGet(item.length);
      handler.datagram(this, item.bytes, item.length);
      synchronized (lock) {
        spareDatagrams.add(item);
      }
      return;
    }
    counters.messagesIn.incrementAndGet();
    counters.messageBytesIn.addAndGet(item.length);
    Object message = codec.decode(item.bytes, 0, item.length);
    if (message == null) {
      counters.malformed.incrementAndGet();
      close("the other side sent a message that can't be decoded");
    } else {
      handler.message(this, message);
    }
  }

  private void reportClose(LinkHandler handler) {
    synchronized (lock) {
      if (state != State.CLOSED || closeReported || !inbox.isEmpty()) {
        return;
      }
      closeReported = true;
    }
    handler.closed(this, closeReason);
  }

  @Override
  public void close(String reason) {
    synchronized (lock) {
      closeBoth(reason);
    }
  }

  private void closeBoth(String reason) {
    if (state == State.CLOSED) {
      return;
    }
    closeReason = reason;
    peer.closeReason = "the connection was closed by the other side";
    state = State.CLOSED;
    peer.state = State.CLOSED;
  }

  @Override
  public String remote() {
    return remote;
  }

  @Override
  public String closeReason() {
    return closeReason;
  }

  @Override
  public LinkCounters counters() {
    return counters;
  }
}
