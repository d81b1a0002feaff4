package carom.net.kryo;

import carom.net.frame.Frame;
import carom.net.frame.FramedLink;
import carom.net.protocol.ClientMessage;
import carom.net.transport.Link;
import com.esotericsoftware.kryonet.Connection;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterTCP;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterUDP;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * One stranger at the server's door, and later one link. KryoNet calls it on the network thread,
 * the {@link DatagramPort} on its own, the link's owner and anybody else who sends on theirs.
 *
 * <p>What keeps the network thread alive and everybody else's game running: nothing here throws,
 * reading never answers null, a connection closes on the network thread only (KryoNet leaves ghosts
 * behind otherwise), a message goes out only when it fits, and a datagram that can't be sent is
 * lost, not a reason to close.
 */
final class ServerConnection extends Connection {

  /**
   * A connection's way in and out; it only moves down this list. The port's thread takes it to
   * CHALLENGED and OPEN, the network thread to CLOSING and CLOSED.
   */
  enum Phase {
    /** TCP is connected, the UDP address unknown. */
    PENDING,
    /** The UDP address is known and has to answer a datagram. */
    CHALLENGED,
    /** The link is open. */
    OPEN,
    /** BYE is sent; what comes in is ignored. */
    CLOSING,
    /** Gone. */
    CLOSED
  }

  private static final long CHALLENGE_NANOS = 100_000_000L;

  final long token;
  private final ServerNetwork network;
  private final ServerLink link;
  private final long nonce;
  private final Object phaseLock = new Object();
  private final AtomicBoolean closeRequested = new AtomicBoolean();
  private final RateBudget messageBudget; // network thread
  private final RateBudget datagramBudget; // the port's thread
  private volatile boolean broken;
  private volatile InetSocketAddress udpAddress;
  private volatile Phase phase = Phase.PENDING; // set under the lock
  private volatile long phaseSince = System.nanoTime();

  // network thread
  private long lastFrame = phaseSince;
  private long lastChallenge = phaseSince;

  /** One household; set before anybody can register for this connection. */
  Object addressKey;

  ServerConnection(ServerNetwork network, long token, long nonce) {
    this.network = network;
    this.token = token;
    this.nonce = nonce;
    KryoLimits limits = network.limits;
    int messages = limits.messagesPerSecond();
    int datagrams = limits.datagramsPerSecond();
    messageBudget = new RateBudget(messages, messages);
    datagramBudget = new RateBudget(datagrams, Math.max(1, datagrams / 2));
    link = new ServerLink(this);
  }

  /** The link's side of a connection. */
  private static final class ServerLink extends FramedLink {
    private final ServerConnection connection;
    private volatile String remote = "unknown";

    ServerLink(ServerConnection connection) {
      super(
          connection.network.codec,
          connection.network.limits.unreadMessages(),
          connection.network.limits.unreadDatagrams());
      this.connection = connection;
    }

    @Override
    public String remote() {
      return remote;
    }

    @Override
    protected boolean transmit(Frame.Payload frame) {
      return connection.sendTCP(frame) > 0;
    }

    @Override
    protected boolean transmitDatagram(byte[] bytes, int offset, int length) {
      return connection.sendDatagram(Frame.DATAGRAM, bytes, offset, length);
    }

    @Override
    protected void disconnect(Link.State before, String reason) {
      connection.sendTCP(Frame.bye(reason)); // wakes the network thread, too
      connection.requestClose();
    }
  }

  Link link() {
    return link;
  }

  Phase phase() {
    return phase;
  }

  void remote(String address) {
    link.remote = address;
  }

  @Override
  public int sendTCP(Object frame) {
    if (frame instanceof RegisterTCP && !network.admit(this)) {
      return 0;
    }
    if (broken) {
      return 0;
    }
    if (network.limits.unsentBytes() - getTcpWriteBufferSize() < FrameCodec.tcpBytes(frame)) {
      fail("the client doesn't read what it is sent");
      return 0;
    }
    try {
      return super.sendTCP(frame);
    } catch (
        RuntimeException
            x) { // overflow by two senders at once, or the key is cancelled: the stream is broken
      fail("connection lost");
      return 0;
    }
  }

  /** Puts a datagram on the wire; false when it was dropped here. Any thread. */
  private boolean sendDatagram(byte tag, byte[] bytes, int offset, int length) {
    InetSocketAddress address = udpAddress;
    return address != null && !broken && network.send(address, tag, bytes, offset, length);
  }

  private void challenge() {
    byte[] fields = Frame.nonce(nonce);
    sendDatagram(Frame.CHALLENGE, fields, 0, fields.length);
  }

  /** KryoNet's own way to end a connection: any error ends here, on any thread. */
  @Override
  public void close() {
    if (network.isNetworkThread()) {
      closeNow(phase == Phase.CLOSING ? "closed" : "the client closed the connection");
    } else {
      abandon("connection lost");
    }
  }

  /** Of no use any more; the network thread shall close it. Any thread. */
  private void abandon(String reason) {
    broken = true;
    link.finish(reason);
    requestClose();
  }

  /** Another connection has the same UDP address now. The port's thread. */
  void giveWay() {
    abandon("a new connection has the same address");
  }

  /**
   * The network thread shall close this connection: after BYE has been answered, or at once when it
   * is broken. Any thread.
   */
  private void requestClose() {
    if (closeRequested.compareAndSet(false, true)) {
      network.requestClose(this);
    }
  }

  /** Answers {@link #requestClose} on the network thread. */
  void closeAsRequested(long now) {
    if (broken || phase == Phase.PENDING || phase == Phase.CHALLENGED) {
      closeNow("closed");
    } else {
      advance(Phase.OPEN, Phase.CLOSING, now);
    }
  }

  /** Tells the client why and closes. Network thread. */
  void dismiss(String reason) {
    sendTCP(Frame.bye(reason));
    closeNow(reason);
  }

  /** Tells the client why, and gives it a moment to take the news and to close. Network thread. */
  void dismissGently(String reason, long now) {
    if (link.finish(reason)) {
      sendTCP(Frame.bye(reason));
    }
    closeAsRequested(now);
  }

  private void expel(String reason) {
    network.counters.expelled.incrementAndGet();
    dismiss(reason);
  }

  /** The TCP stream is of no use any more. Any thread. */
  private void fail(String reason) {
    if (broken) {
      return;
    }
    broken = true;
    network.counters.expelled.incrementAndGet();
    if (network.isNetworkThread()) {
      closeNow(reason);
    } else {
      abandon(reason);
    }
  }

  /** The end. Network thread. */
  void closeNow(String reason) {
    synchronized (phaseLock) {
      if (phase == Phase.CLOSED) {
        return;
      }
      phase = Phase.CLOSED;
    }
    broken = true;
    link.finish(reason);
    network.forget(this, udpAddress);
    super.close();
  }

  /** From one phase to the next; false when it was in another one, such as closed. */
  private boolean advance(Phase from, Phase to, long now) {
    synchronized (phaseLock) {
      if (phase != from) {
        return false;
      }
      phaseSince = now;
      phase = to;
      return true;
    }
  }

  /** The client told its UDP address; telling it again means nothing. The port's thread. */
  void addressKnown(InetSocketAddress address, long now) {
    synchronized (phaseLock) { // or a connection that closes meanwhile would leave its address
      if (!advance(Phase.PENDING, Phase.CHALLENGED, now)) {
        return;
      }
      udpAddress = address;
      network.registered(this, address);
    }
    sendTCP(new RegisterUDP());
    challenge();
  }

  /** Looks after deadlines; some 20 times a second. Network thread. */
  void sweep(long now) {
    KryoLimits limits = network.limits;
    long inPhase = now - phaseSince;
    long handshakeNanos = limits.handshakeMillis() * 1_000_000L;
    switch (phase) {
      case PENDING -> {
        if (inPhase > handshakeNanos) {
          network.counters.expired.incrementAndGet();
          dismiss(
              "server reachable by TCP, but UDP port "
                  + network.udpPort()
                  + " is blocked (by a firewall or router)");
        }
      }
      case CHALLENGED -> {
        if (inPhase > handshakeNanos) {
          network.counters.expired.incrementAndGet();
          dismiss(
              "server reachable, but its answers from UDP port "
                  + network.udpPort()
                  + " are blocked (by a firewall or router)");
        } else if (now - Math.max(phaseSince, lastChallenge) >= CHALLENGE_NANOS) {
          lastChallenge = now;
          challenge();
        }
      }
      case OPEN -> {
        if (now - Math.max(phaseSince, lastFrame) > limits.idleMillis() * 1_000_000L) {
          expel("nothing heard for " + limits.idleMillis() + " ms");
        }
      }
      case CLOSING -> {
        if (inPhase > Frame.LINGER_NANOS) {
          closeNow("closed");
        }
      }
      case CLOSED -> {}
    }
  }

  /** Reads a TCP frame. Network thread. */
  Object readFrame(ByteBuffer buffer) {
    if (phase == Phase.CLOSED) {
      return FrameCodec.HANDLED;
    }
    if (phase == Phase.PENDING) {
      closeNow("talked before the handshake");
      return FrameCodec.HANDLED;
    }
    long now = System.nanoTime();
    lastFrame = now;
    if (!messageBudget.take(now)) {
      expel("more than " + network.limits.messagesPerSecond() + " messages per second");
      return FrameCodec.HANDLED;
    }
    byte tag = buffer.get();
    if (tag == Frame.KEEP_ALIVE && !buffer.hasRemaining()) {
      return FrameCodec.HANDLED;
    }
    if (tag == Frame.BYE) {
      closeNow("the client left");
      return FrameCodec.HANDLED;
    }
    if (phase == Phase.CLOSING) {
      return FrameCodec.HANDLED;
    }
    int length = buffer.remaining();
    ClientMessage message =
        tag == Frame.MESSAGE
            ? network.codec.decodeFromClient(
                buffer.array(), buffer.arrayOffset() + buffer.position(), length)
            : null;
    if (message == null) {
      link.counters().malformed.incrementAndGet();
      expel("bytes that are no message (tag=" + tag + " length=" + length + ")");
    } else if (!link.receiveMessage(message, length)) {
      expel("more than " + network.limits.unreadMessages() + " unread messages");
    }
    return FrameCodec.HANDLED;
  }

  /** Reads a datagram from this connection's address. The port's thread. */
  void readDatagram(ByteBuffer buffer, long now) {
    if (!datagramBudget.take(now)) {
      network.counters.excessDatagrams.incrementAndGet();
      link.counters().datagramsDropped.incrementAndGet();
      return;
    }
    int length = buffer.remaining();
    byte tag = length == 0 ? 0 : buffer.get(buffer.position());
    if (tag == Frame.DATAGRAM && length > 1 && length <= 1 + Frame.MAX_PAYLOAD_BYTES) {
      if (phase == Phase.OPEN) {
        buffer.get();
        link.receiveDatagram(buffer, now);
      }
    } else if (tag == Frame.ANSWER && length == Frame.NONCE_BYTES) {
      if (buffer.getLong(buffer.position() + 1) == nonce
          && advance(Phase.CHALLENGED, Phase.OPEN, now)) {
        network.opened(this, link);
      }
    } else if (tag == Frame.REGISTER_UDP && length == Frame.REGISTRATION_BYTES) {
      network.register(udpAddress, buffer, now); // a repetition, or a successor's
    } else if (tag != Frame.KEEP_ALIVE || length != 1) {
      network.counters.malformedDatagrams.incrementAndGet();
    }
  }

  boolean openLink() {
    return link.open();
  }
}
