package carom.net.kryo;

import carom.net.protocol.ClientMessage;
import carom.net.transport.Link;
import com.esotericsoftware.kryonet.Connection;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterTCP;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterUDP;
import java.nio.ByteBuffer;

/**
 * One stranger at the server's door, and later one link. KryoNet calls it on the network thread,
 * the link's owner and anybody else who sends on theirs.
 *
 * <p>What keeps the network thread alive and everybody else's game running: nothing here throws,
 * reading never answers null, a connection closes on the network thread only (KryoNet leaves ghosts
 * behind otherwise), a message goes out only when it fits, and a datagram that can't be sent is
 * lost, not a reason to close.
 */
final class ServerConnection extends Connection {

  /** A connection's way in and out; it only moves down this list. Network thread. */
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
  private final Frame.Payload challenge;
  private final Frame.Payload datagram = new Frame.Payload();
  private final Object datagramLock = new Object();
  private final RateBudget messageBudget;
  private final RateBudget datagramBudget;
  private volatile boolean registered;
  private volatile boolean broken;
  private volatile boolean closeRequested;
  private volatile Thread datagramSender;

  // network thread
  Object addressKey;
  private Phase phase = Phase.PENDING;
  private long phaseSince = System.nanoTime();
  private long lastFrame = phaseSince;
  private long lastChallenge;

  ServerConnection(ServerNetwork network, long token, long nonce) {
    this.network = network;
    this.token = token;
    this.nonce = nonce;
    challenge = Frame.nonce(Frame.CHALLENGE, nonce);
    KryoLimits limits = network.limits;
    int messages = limits.messagesPerSecond();
    int datagrams = limits.datagramsPerSecond();
    messageBudget = new RateBudget(messages, messages);
    datagramBudget = new RateBudget(datagrams, Math.max(1, datagrams / 2));
    link = new ServerLink(this);
  }

  /** The link's side of a connection. */
  private static final class ServerLink extends KryoLink {
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
    boolean transmit(Frame.Payload frame) {
      return connection.sendTCP(frame) > 0;
    }

    @Override
    boolean transmitDatagram(byte[] bytes, int offset, int length) {
      synchronized (connection.datagramLock) {
        return connection.sendUDP(connection.datagram.set(Frame.DATAGRAM, bytes, offset, length))
            > 0;
      }
    }

    @Override
    void disconnect(Link.State before, String reason) {
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
    if (network.limits.unsentBytes() - getTcpWriteBufferSize() < Frame.tcpBytes(frame)) {
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

  @Override
  public int sendUDP(Object frame) {
    if (!registered) {
      return 0;
    }
    synchronized (datagramLock) {
      datagramSender = Thread.currentThread();
      try {
        return super.sendUDP(frame);
      } catch (RuntimeException x) {
        return 0;
      } finally {
        datagramSender = null;
      }
    }
  }

  /** KryoNet's own way to end a connection: any error ends here, on any thread. */
  @Override
  public void close() {
    if (datagramSender == Thread.currentThread()) {
      return; // a datagram that can't be sent is lost, and that's all
    }
    if (network.isNetworkThread()) {
      closeNow(phase == Phase.CLOSING ? "closed" : "the client closed the connection");
    } else {
      broken = true;
      link.finish("connection lost");
      requestClose();
    }
  }

  /**
   * The network thread shall close this connection: after BYE has been answered, or at once when it
   * is broken. Any thread.
   */
  private void requestClose() {
    synchronized (datagramLock) {
      if (closeRequested) {
        return;
      }
      closeRequested = true;
    }
    network.requestClose(this);
  }

  /** Answers {@link #requestClose} on the network thread. */
  void closeAsRequested(long now) {
    if (broken || phase == Phase.PENDING || phase == Phase.CHALLENGED) {
      closeNow("closed");
    } else if (phase == Phase.OPEN) {
      enter(Phase.CLOSING, now);
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
      link.finish(reason);
      requestClose();
    }
  }

  /** The end. Network thread. */
  void closeNow(String reason) {
    if (phase == Phase.CLOSED) {
      return;
    }
    phase = Phase.CLOSED;
    broken = true;
    registered = false;
    link.finish(reason);
    network.forget(this);
    super.close();
  }

  private void enter(Phase next, long now) {
    phase = next;
    phaseSince = now;
  }

  /** KryoNet knows the UDP address now. Network thread. */
  void addressKnown(long now) {
    if (phase != Phase.PENDING) {
      return;
    }
    registered = true;
    network.registered(this);
    enter(Phase.CHALLENGED, now);
    challenge(now);
  }

  private void challenge(long now) {
    lastChallenge = now;
    sendUDP(challenge);
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
                  + network.udpPort
                  + " is blocked (by a firewall or router)");
        }
      }
      case CHALLENGED -> {
        if (inPhase > handshakeNanos) {
          network.counters.expired.incrementAndGet();
          dismiss(
              "server reachable, but its answers from UDP port "
                  + network.udpPort
                  + " are blocked (by a firewall or router)");
        } else if (now - lastChallenge >= CHALLENGE_NANOS) {
          challenge(now);
        }
      }
      case OPEN -> {
        if (now - lastFrame > limits.idleMillis() * 1_000_000L) {
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
      return Frame.HANDLED;
    }
    long now = System.nanoTime();
    lastFrame = now;
    if (!messageBudget.take(now)) {
      expel("more than " + network.limits.messagesPerSecond() + " messages per second");
      return Frame.HANDLED;
    }
    byte tag = buffer.get();
    if (tag == Frame.KEEP_ALIVE && !buffer.hasRemaining()) {
      return Frame.HANDLED;
    }
    if (tag == Frame.BYE) {
      closeNow("the client left");
      return Frame.HANDLED;
    }
    if (phase == Phase.CLOSING) {
      return Frame.HANDLED;
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
    return Frame.HANDLED;
  }

  /** Reads a datagram from this connection's address. Network thread. */
  Object readDatagram(ByteBuffer buffer) {
    long now = System.nanoTime();
    if (!datagramBudget.take(now)) {
      network.counters.excessDatagrams.incrementAndGet();
      link.counters().datagramsDropped.incrementAndGet();
      return Frame.HANDLED;
    }
    int length = buffer.remaining();
    byte tag = length == 0 ? 0 : buffer.get();
    if (tag == Frame.DATAGRAM && length > 1 && length <= 1 + Frame.MAX_PAYLOAD_BYTES) {
      if (phase == Phase.OPEN) {
        link.receiveDatagram(buffer);
      }
    } else if (tag == Frame.ANSWER && length == Frame.NONCE_BYTES) {
      if (buffer.getLong() == nonce && phase == Phase.CHALLENGED) {
        enter(Phase.OPEN, now);
        lastFrame = now;
        network.opened(this, link);
      }
    } else if (tag == Frame.REGISTER_UDP && length == Frame.REGISTRATION_BYTES) {
      return successor(buffer);
    } else if (tag != Frame.KEEP_ALIVE || length != 1) {
      network.counters.malformedDatagrams.incrementAndGet();
    }
    return Frame.HANDLED;
  }

  /**
   * A newcomer registers the address that this connection has. Its client crashed or moved on
   * without a word, and the system gave its port to the next one; so this one ends, unless the
   * newcomer's TCP comes from another machine: then the datagram's source is forged.
   */
  private Object successor(ByteBuffer buffer) {
    ServerConnection newcomer = network.pending(buffer.getInt(), buffer.getLong());
    if (newcomer == null || !newcomer.addressKey.equals(addressKey)) {
      return Frame.HANDLED;
    }
    closeNow("a new connection has the same address");
    RegisterUDP register = new RegisterUDP();
    register.connectionID = newcomer.getID();
    return register;
  }

  boolean openLink() {
    return link.open();
  }
}
