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
 * One connection of an unknown client, and later its link. KryoNet calls it on the network thread,
 * {@link DatagramPort} on its own thread, and the link's owner and other senders on theirs.
 *
 * <p>These rules keep the network thread and the other players' games alive. Nothing here throws.
 * Reading never returns null. A connection closes on the network thread only, because KryoNet
 * otherwise keeps dead connections. A message is sent only if it fits. A datagram that can't be
 * sent is lost and closes nothing.
 */
final class ServerConnection extends Connection {

  /**
   * Phase of a connection. It only moves down this list. The port's thread sets CHALLENGED and
   * OPEN, the network thread CLOSING and CLOSED.
   */
  enum Phase {
    /** TCP is connected, and the UDP address is unknown. */
    PENDING,
    /** The UDP address is known and must answer a challenge. */
    CHALLENGED,
    /** The link is open. */
    OPEN,
    /** The server has sent BYE and ignores what comes in. */
    CLOSING,
    /** The connection is closed. */
    CLOSED
  }

  private static final long CHALLENGE_NANOS = 100_000_000L;

  final long token;
  private final ServerNetwork network;
  private final ServerLink link;
  private final long nonce;
  private final Object phaseLock = new Object();
  private final AtomicBoolean closeRequested = new AtomicBoolean();
  private final TokenBucket messageBudget; // used by the network thread
  private final TokenBucket datagramBudget; // used by the port's thread
  private volatile boolean broken;
  private volatile InetSocketAddress udpAddress;
  private volatile Phase phase = Phase.PENDING; // set under the lock
  private volatile long phaseSince = System.nanoTime();

  // used by the network thread
  private long lastFrame = phaseSince;
  private long lastChallenge = phaseSince;

  /** Address group that counts as one household. It is set before the client can register UDP. */
  Object addressKey;

  ServerConnection(ServerNetwork network, long token, long nonce) {
    this.network = network;
    this.token = token;
    this.nonce = nonce;
    KryoLimits limits = network.limits;
    int messages = limits.messagesPerSecond();
    int datagrams = limits.datagramsPerSecond();
    messageBudget = new TokenBucket(messages, messages);
    datagramBudget = new TokenBucket(datagrams, Math.max(1, datagrams / 2));
    link = new ServerLink(this);
  }

  /** The link of a connection. */
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
      connection.sendTCP(Frame.bye(reason)); // also wakes the network thread
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
            x) { // two senders overflowed the buffer at once, or the key is cancelled: the stream
      // is broken
      fail("connection lost");
      return 0;
    }
  }

  /** Sends a datagram. Returns false when this end dropped it. Any thread may call it. */
  private boolean sendDatagram(byte tag, byte[] bytes, int offset, int length) {
    InetSocketAddress address = udpAddress;
    return address != null && !broken && network.send(address, tag, bytes, offset, length);
  }

  private void challenge() {
    byte[] fields = Frame.nonce(nonce);
    sendDatagram(Frame.CHALLENGE, fields, 0, fields.length);
  }

  /** Ends the connection. KryoNet calls this after any error, on any thread. */
  @Override
  public void close() {
    if (network.isNetworkThread()) {
      closeNow(phase == Phase.CLOSING ? "closed" : "the client closed the connection");
    } else {
      abandon("connection lost");
    }
  }

  /** Marks the connection as broken and requests its close. Any thread may call it. */
  private void abandon(String reason) {
    broken = true;
    link.finish(reason);
    requestClose();
  }

  /**
   * Abandons this connection because another one has its UDP address now. Called on the port's
   * thread.
   */
  void supersede() {
    abandon("a new connection has the same address");
  }

  /**
   * Requests that the network thread closes this connection, after the client has answered BYE, or
   * at once if the connection is broken. Any thread may call it.
   */
  private void requestClose() {
    if (closeRequested.compareAndSet(false, true)) {
      network.requestClose(this);
    }
  }

  /** Carries out {@link #requestClose} on the network thread. */
  void closeAsRequested(long now) {
    if (broken || phase == Phase.PENDING || phase == Phase.CHALLENGED) {
      closeNow("closed");
    } else {
      advance(Phase.OPEN, Phase.CLOSING, now);
    }
  }

  /** Tells the client why, and closes at once. Called on the network thread. */
  void dismiss(String reason) {
    sendTCP(Frame.bye(reason));
    closeNow(reason);
  }

  /**
   * Tells the client why, and gives it a moment to read the reason and close. Called on the network
   * thread.
   */
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

  /** Marks the TCP stream as broken and closes the connection. Any thread may call it. */
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

  /** Closes the connection at once. Called on the network thread. */
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

  /**
   * Moves from one phase to the next. Returns false when the connection was in another phase, such
   * as CLOSED.
   */
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

  /** Records the client's UDP address. A repetition has no effect. Called on the port's thread. */
  void addressKnown(InetSocketAddress address, long now) {
    synchronized (
        phaseLock) { // without the lock, a connection that closes meanwhile would leave its address
      // behind
      if (!advance(Phase.PENDING, Phase.CHALLENGED, now)) {
        return;
      }
      udpAddress = address;
      network.registered(this, address);
    }
    sendTCP(new RegisterUDP());
    challenge();
  }

  /** Checks deadlines, about 20 times a second. Called on the network thread. */
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

  /** Reads a TCP frame. Called on the network thread. */
  Object readFrame(ByteBuffer buffer) {
    if (phase == Phase.CLOSED) {
      return FrameCodec.HANDLED;
    }
    if (phase == Phase.PENDING) {
      closeNow("the client sent a frame before the handshake");
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
      expel("the client sent an invalid message (tag=" + tag + " length=" + length + ")");
    } else if (!link.receiveMessage(message, length)) {
      expel("more than " + network.limits.unreadMessages() + " unread messages");
    }
    return FrameCodec.HANDLED;
  }

  /** Reads a datagram from this connection's address. Called on the port's thread. */
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
      network.register(udpAddress, buffer, now); // a repetition, or the registration of a successor
    } else if (tag != Frame.KEEP_ALIVE || length != 1) {
      network.counters.malformedDatagrams.incrementAndGet();
    }
  }

  boolean openLink() {
    return link.open();
  }
}
