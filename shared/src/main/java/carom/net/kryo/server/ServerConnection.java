package carom.net.kryo.server;

import carom.net.admission.AddressGroup;
import carom.net.admission.Entrance;
import carom.net.admission.TokenBucket;
import carom.net.frame.DatagramPath;
import carom.net.frame.Frame;
import carom.net.frame.FramedLink;
import carom.net.kryo.FrameCodec;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.ClientMessageCodec;
import carom.net.seal.DatagramOpener;
import carom.net.seal.DatagramSealer;
import carom.net.seal.Encryption;
import carom.net.seal.KeyExchange;
import carom.net.seal.LinkKeys;
import carom.net.seal.StreamSeal;
import carom.net.transport.HandshakeLine;
import carom.net.transport.Link;
import com.esotericsoftware.kryonet.Connection;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterTCP;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterUDP;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.security.GeneralSecurityException;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * One connection of an unknown client, and later its link. KryoNet calls it on the network thread,
 * {@code DatagramPort} on its own thread, and the link's owner and other senders on theirs.
 *
 * <p>These rules keep the network thread and the other players' games alive. Nothing here throws.
 * Reading never returns null. A connection closes on the network thread only, because KryoNet
 * otherwise keeps dead connections. A message is sent only if it fits. A datagram that can't be
 * sent is lost and closes nothing.
 */
final class ServerConnection extends Connection implements Entrance.Guest {

  /**
   * Phase of a connection. It only moves down this list. The port's thread sets KEYING and OPEN,
   * the network thread the others.
   */
  enum Phase {
    /** TCP is connected, and the UDP address is unknown. */
    PENDING,
    /** The UDP address is known, and the two sides exchange keys. */
    KEYING,
    /** Both sides have the keys, and the UDP address must answer a challenge. */
    CHALLENGED,
    /** The link is open. */
    OPEN,
    /** The server has sent BYE and ignores what comes in. */
    CLOSING,
    /** The connection is closed. */
    CLOSED
  }

  private static final long CHALLENGE_NANOS = 100_000_000L;

  private final ServerNetwork network;
  private final ServerLink link;
  private final long token;
  private final long nonce;
  private final InetSocketAddress behindProxy; // null for a client that comes by itself
  private final Object phaseLock = new Object();
  private final AtomicBoolean closeRequested = new AtomicBoolean();
  private final TokenBucket messageBudget; // used by the network thread
  private final TokenBucket datagramBudget; // used by the port's thread
  private final TokenBucket streamedBudget; // used by the network thread
  private final FloodMeter floodMeter; // used by the port's thread
  private final AddressChangeLimit addressChangeLimit; // used by the port's thread
  private final Object sealing = new Object();
  private final Object streaming = new Object();
  private volatile LinkKeys keys; // its sealer of datagrams is guarded by the lock above
  private StreamSeal streamSeal; // guarded by KryoNet's lock of the stream
  private volatile boolean broken;
  private volatile InetSocketAddress udpAddress;
  private volatile Phase phase = Phase.PENDING; // set under the lock
  private volatile long phaseSince = System.nanoTime();

  // used by the network thread
  private long lastFrame = phaseSince;
  private boolean offered;
  private boolean streams; // the client can't use UDP

  // used by the port's thread
  private InetSocketAddress newAddress;
  private long newNonce;
  private long newSince;

  // set by the network thread before the client hears of this connection
  private volatile int number;
  private byte[] greeting;
  private int workBits;
  private AddressGroup origin;

  ServerConnection(ServerNetwork network, long token, long nonce, InetSocketAddress behindProxy) {
    this.behindProxy = behindProxy;
    this.network = network;
    this.token = token;
    this.nonce = nonce;
    KryoLimits limits = network.limits;
    int messages = limits.messagesPerSecond();
    int datagrams = limits.datagramsPerSecond();
    messageBudget = new TokenBucket(messages, messages);
    datagramBudget = new TokenBucket(datagrams, Math.max(1, datagrams / 2));
    streamedBudget = new TokenBucket(datagrams, Math.max(1, datagrams / 2));
    floodMeter = new FloodMeter(datagrams);
    addressChangeLimit = new AddressChangeLimit(network.addressChanges);
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
    public byte[] binding() {
      LinkKeys current = connection.keys;
      return current == null ? null : current.binding();
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
      long now = System.nanoTime();
      return path.isOverTcp(now)
          ? path.isFree(now) && connection.stream(bytes, offset, length)
          : connection.sendDatagram(connection.udpAddress, Frame.DATAGRAM, bytes, offset, length);
    }

    DatagramPath path() {
      return path;
    }

    @Override
    protected void disconnect(Link.State before, String reason) {
      connection.sendTCP(Frame.bye(reason)); // also wakes the network thread
      connection.requestClose();
    }
  }

  Phase phase() {
    return phase;
  }

  @Override
  public Entrance.Proof proof() {
    return switch (phase) {
      case PENDING -> Entrance.Proof.UNPROVEN;
      case KEYING, CHALLENGED -> Entrance.Proof.PROVEN;
      default -> Entrance.Proof.IN;
    };
  }

  @Override
  public AddressGroup origin() {
    return origin;
  }

  /** Returns where the client connects from, perhaps by a proxy's word; null if it has gone. */
  InetSocketAddress clientAddress() {
    return behindProxy == null ? getRemoteAddressTCP() : behindProxy;
  }

  /** Notes where the client is, before it hears of this connection. */
  void origin(AddressGroup from) {
    origin = from;
  }

  /** Returns how much work the client must prove before any key is computed for it. */
  int workBits() {
    return workBits;
  }

  /** Returns the number that this connection's datagrams carry, or 0 before it is admitted. */
  int number() {
    return number;
  }

  /** Returns what the client is told first. */
  byte[] greeting() {
    return greeting;
  }

  /** Returns the number that the client must know to register. */
  long token() {
    return token;
  }

  /** Returns whether a token is this connection's. */
  boolean hasToken(long other) {
    return token == other; // compares all 64 bits at once, whatever they are
  }

  /** Notes this connection's number, and what the client is told first. */
  void admitted(int asNumber, int bits) {
    workBits = bits;
    greeting = network.greeting(asNumber, token, bits);
    number = asNumber; // volatile: the port's thread sees what was set before
  }

  /** Returns the seal of what leaves by TCP, or null before. Call it under the stream's lock. */
  StreamSeal streamSeal() {
    return streamSeal;
  }

  /** Seals all that follows in the stream. Call it under the stream's lock. */
  void sealStream() {
    streamSeal = keys.streamOut();
  }

  void remote(String address) {
    link.remote = address;
  }

  @Override
  public int sendTCP(Object frame) {
    if (frame instanceof RegisterTCP && !network.admit(this)) {
      return 0;
    }
    HandshakeLine line = network.line;
    boolean isBye = frame instanceof Frame.Payload payload && payload.tag() == Frame.BYE;
    if (line != null && phase.compareTo(Phase.OPEN) < 0 && !isBye) {
      line.after(line.roundTripNanos(), () -> write(frame));
      return 1;
    }
    return write(frame);
  }

  private int write(Object frame) {
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
  private boolean sendDatagram(
      InetSocketAddress to, byte tag, byte[] bytes, int offset, int length) {
    LinkKeys current = keys;
    if (to == null || current == null || broken) {
      return false;
    }
    DatagramSealer sealer = current.datagramsOut();
    synchronized (sealing) {
      if (sealer.isUsedUp()) {
        abandon("the keys of this connection are used up");
        return false;
      }
      int sealed = sealer.seal(tag, bytes, offset, length);
      return network.send(to, sealer.bytes(), sealed);
    }
  }

  /**
   * Sends a datagram over TCP, or only what this end has to say of the datagrams if the length is
   * 0. Returns false when it would wait behind others. Any thread may call it.
   */
  private boolean stream(byte[] bytes, int offset, int length) {
    synchronized (streaming) { // heads must leave in the order of their counts
      return getTcpWriteBufferSize() == 0
          && sendTCP(Frame.streamed(link.path(), bytes, offset, length)) > 0;
    }
  }

  private void challenge(InetSocketAddress address, long number) {
    byte[] fields = Frame.nonce(number);
    HandshakeLine line = network.line;
    if (line == null) {
      sendDatagram(address, Frame.CHALLENGE, fields, 0, fields.length);
    } else if (!line.loses()) {
      line.after(
          line.roundTripNanos(),
          () -> sendDatagram(address, Frame.CHALLENGE, fields, 0, fields.length));
    }
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
    if (broken || phase.compareTo(Phase.OPEN) < 0) {
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

  /** Closes at once if the server has sent BYE. Called on the network thread. */
  void leave() {
    if (phase == Phase.CLOSING) {
      closeNow("closed");
    }
  }

  /** Closes the connection at once. Called on the network thread. */
  void closeNow(String reason) {
    boolean wasOpen;
    synchronized (phaseLock) {
      if (phase == Phase.CLOSED) {
        return;
      }
      wasOpen = phase.compareTo(Phase.OPEN) >= 0;
      phase = Phase.CLOSED;
    }
    broken = true;
    link.finish(reason);
    network.forget(this, udpAddress, wasOpen);
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

  /**
   * Records the client's UDP address. A repetition asks for another challenge, if one is due.
   * Called on the port's thread.
   */
  void addressKnown(InetSocketAddress address, long now) {
    long waited = now - phaseSince;
    if (advance(Phase.PENDING, Phase.KEYING, now)) {
      udpAddress = address;
      link.path().roundTrip(waited);
      sendTCP(new RegisterUDP());
    } else if (phase == Phase.CHALLENGED && address.equals(udpAddress)) {
      challenge(address, nonce); // the address gets no more bytes than came from it
    }
  }

  /**
   * Takes the client's word that UDP is blocked, for a proof of work: TCP's own handshake has shown
   * the client's address. The client may have registered a UDP address that it can't use, which
   * nobody has proven. Returns false when the frame means nothing here.
   */
  private boolean readStream(byte[] fields, int offset, int length, long now) {
    ByteBuffer solution = ByteBuffer.wrap(fields, offset, length);
    if (length != Frame.SOLUTION_BYTES
        || !network.hasWorked(this, Frame.streamWorkBits(workBits), solution.getLong())) {
      return false;
    }
    streams = true;
    if (advance(Phase.PENDING, Phase.KEYING, now) || phase == Phase.KEYING) {
      udpAddress = null;
      sendTCP(new RegisterUDP());
      return true;
    }
    return openStream(Phase.CHALLENGED, now);
  }

  private boolean openStream(Phase from, long now) {
    if (!advance(from, Phase.OPEN, now)) {
      return phase == Phase.OPEN; // its answer came by UDP after all
    }
    udpAddress = null;
    network.opened(this, null, link);
    return true;
  }

  /** Starts the exchange of keys. Called on the network thread; another one computes them. */
  private void readOffer(byte[] offer) {
    Encryption encryption = network.identity.encryption();
    if (offered) {
      expel("the client offered two keys");
    } else if (offer[0] != encryption.code()) {
      dismiss(
          encryption == Encryption.ON
              ? "this server encrypts; connect without --encryption off"
              : "this server doesn't encrypt; if you trust the network, connect with"
                  + " --encryption off");
    } else {
      offered = true;
      network.computeKeys(() -> answer(offer));
    }
  }

  /** Computes the keys and answers. Called on the thread for keys. */
  private void answer(byte[] offer) {
    if (phase != Phase.KEYING) {
      return; // the client has left
    }
    try {
      ServerIdentity self = network.identity;
      KeyExchange.Answer answer =
          KeyExchange.answer(
              self.encryption(), self.key(), greeting, offer, number, Frame.MAX_PAYLOAD_BYTES);
      keys = answer.keys();
      byte[] bytes = answer.bytes();
      sendTCP(new Frame.Payload().set(Frame.KEY_ANSWER, bytes, 0, bytes.length));
    } catch (GeneralSecurityException x) {
      network.counters.expelled.incrementAndGet();
      String reason = "the connection was tampered with: the offered key isn't for this server";
      sendTCP(Frame.bye(reason));
      abandon(reason);
    }
  }

  private void confirm(long now) {
    if (streams) {
      openStream(Phase.KEYING, now);
    } else if (advance(Phase.KEYING, Phase.CHALLENGED, now)) {
      challenge(udpAddress, nonce); // answers the registration
    }
  }

  /** Checks deadlines, about 20 times a second. Called on the network thread. */
  void sweep(long now) {
    KryoLimits limits = network.limits;
    long inPhase = now - phaseSince;
    long handshakeNanos = network.handshakeNanos();
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
      case KEYING -> {
        if (inPhase > handshakeNanos) {
          network.counters.expired.incrementAndGet();
          dismiss("the exchange of keys took longer than " + handshakeNanos / 1_000_000L + " ms");
        }
      }
      case CHALLENGED -> {
        if (inPhase > handshakeNanos) {
          network.counters.expired.incrementAndGet();
          dismiss(
              "server reachable, but its answers from UDP port "
                  + network.udpPort()
                  + " are blocked (by a firewall or router)");
        }
      }
      case OPEN -> {
        if (now - Math.max(phaseSince, lastFrame) > limits.idleMillis() * 1_000_000L) {
          expel("nothing heard for " + limits.idleMillis() + " ms");
        } else if (link.path().mustSpeak(now)) {
          stream(Frame.NO_FIELDS, 0, 0);
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
    long now = System.nanoTime();
    if (phase == Phase.PENDING) {
      byte[] bytes = buffer.array();
      int start = buffer.arrayOffset() + buffer.position();
      if (bytes[start] != Frame.STREAM
          || !readStream(bytes, start + 1, buffer.remaining() - 1, now)) {
        closeNow("the client sent a frame before the handshake");
      }
      return FrameCodec.HANDLED;
    }
    lastFrame = now;
    if (!messageBudget.take(now)) {
      expel("more than " + network.limits.messagesPerSecond() + " messages per second");
      return FrameCodec.HANDLED;
    }
    byte[] bytes = buffer.array();
    int start = buffer.arrayOffset() + buffer.position();
    int length = buffer.remaining();
    if (phase == Phase.KEYING && readClear(bytes, start, length)) {
      return FrameCodec.HANDLED;
    }
    LinkKeys current = keys;
    length = current == null ? -1 : current.streamIn().open(bytes, start, length);
    if (length < 1) {
      expel(current == null ? "the client sent a frame before the keys" : "a frame isn't genuine");
      return FrameCodec.HANDLED;
    }
    readOpened(bytes[start], bytes, start + 1, length - 1, now);
    return FrameCodec.HANDLED;
  }

  /** Reads a frame that comes in the clear. Returns false when it must be a sealed one. */
  private boolean readClear(byte[] bytes, int start, int length) {
    if (length == 1 && bytes[start] == Frame.KEEP_ALIVE) {
      return true;
    }
    if (bytes[start] == Frame.STREAM && !offered) {
      return readStream(bytes, start + 1, length - 1, System.nanoTime());
    }
    if (length == 1 + KeyExchange.OFFER_BYTES && bytes[start] == Frame.KEY_OFFER && keys == null) {
      readOffer(Arrays.copyOfRange(bytes, start + 1, start + length));
      return true;
    }
    return false;
  }

  /** Reads the fields of a frame that is genuine. */
  private void readOpened(byte tag, byte[] bytes, int offset, int length, long now) {
    if (phase == Phase.KEYING) {
      if (tag == Frame.KEY_CONFIRM && length == 0) {
        confirm(now);
      } else {
        expel("the client sent a frame before the handshake");
      }
    } else if (tag == Frame.BYE) {
      closeNow("the client left");
    } else if (tag == Frame.STREAM || tag == Frame.STREAMED) {
      boolean isValid =
          tag == Frame.STREAM
              ? readStream(bytes, offset, length, now)
              : readStreamed(ByteBuffer.wrap(bytes, offset, length), now);
      if (!isValid && phase != Phase.CLOSING) {
        expel("the client sent an invalid frame (tag=" + tag + " length=" + length + ")");
      }
    } else if (phase != Phase.CLOSING && (tag != Frame.KEEP_ALIVE || length > 0)) {
      readMessage(tag, bytes, offset, length);
    }
  }

  private boolean readStreamed(ByteBuffer fields, long now) {
    if (phase != Phase.OPEN || !Frame.readStreamed(link.path(), fields, now)) {
      return false;
    }
    if (!fields.hasRemaining()) {
      return true;
    }
    if (streamedBudget.take(now)) {
      link.receiveDatagram(fields, now);
    } else {
      network.counters.excessDatagrams.incrementAndGet();
      link.counters().datagramsDropped.incrementAndGet();
    }
    return true;
  }

  private void readMessage(byte tag, byte[] bytes, int offset, int length) {
    ClientMessage message =
        tag == Frame.MESSAGE ? ClientMessageCodec.decode(bytes, offset, length) : null;
    if (message == null) {
      link.counters().malformed.incrementAndGet();
      expel("the client sent an invalid message (tag=" + tag + " length=" + length + ")");
    } else if (!link.receiveMessage(message, length)) {
      expel("more than " + network.limits.unreadMessages() + " unread messages");
    }
  }

  /**
   * Reads a datagram that names this connection. Only one that is genuine and new counts for
   * anything: others cost the client nothing. Called on the port's thread.
   *
   * @param bytes the datagram; opened in place
   * @param opened a view of the same bytes
   */
  void readDatagram(InetSocketAddress from, byte[] bytes, int length, ByteBuffer opened, long now) {
    LinkKeys current = keys;
    InetSocketAddress present = udpAddress; // known before the keys are
    boolean elsewhere = current != null && !from.equals(present) && !from.equals(newAddress);
    if (elsewhere && !addressChangeLimit.take(from, present, now)) {
      network.counters.strangeDatagrams.incrementAndGet();
      return;
    }
    int fields =
        current == null ? DatagramOpener.FORGED : current.datagramsIn().open(bytes, length);
    if (fields == DatagramOpener.FORGED) {
      if (elsewhere) {
        addressChangeLimit.forged(from, now);
      }
      network.counters.forgedDatagrams.incrementAndGet();
      return;
    }
    if (fields == DatagramOpener.REPLAYED) {
      network.counters.replayedDatagrams.incrementAndGet();
      return;
    }
    if (floodMeter.count(now) && link.state() == Link.State.OPEN) {
      network.hosts.refuseForAWhile(origin.host(), now);
      network.counters.expelled.incrementAndGet();
      link.close(
          "more than "
              + FloodMeter.FACTOR * network.limits.datagramsPerSecond()
              + " datagrams per second");
      return;
    }
    if (!datagramBudget.take(now)) {
      network.counters.excessDatagrams.incrementAndGet();
      link.counters().datagramsDropped.incrementAndGet();
      return;
    }
    link.path().heardByUdp(bytes[0] == Frame.DATAGRAM, now);
    opened.limit(DatagramSealer.HEAD_BYTES + fields).position(DatagramSealer.HEAD_BYTES);
    readOpened(bytes[0], from, opened, now);
  }

  private void readOpened(byte tag, InetSocketAddress from, ByteBuffer fields, long now) {
    int length = fields.remaining();
    if (tag == Frame.ANSWER && length == Frame.NONCE_BYTES) {
      readAnswer(from, fields.getLong(), now);
      return;
    }
    boolean payable = DatagramSealer.EXTRA_BYTES + 1 + length >= Frame.CHALLENGE_BYTES;
    if (payable && phase == Phase.OPEN && !from.equals(udpAddress)) {
      challengeNewAddress(from, now);
    } else if (payable && phase == Phase.CHALLENGED && from.equals(udpAddress)) {
      challenge(from, nonce); // the client's answer was lost
    }
    if (tag == Frame.DATAGRAM && length > 0 && length <= Frame.MAX_PAYLOAD_BYTES) {
      if (phase == Phase.OPEN) {
        link.receiveDatagram(fields, now);
      }
    } else if (tag == Frame.KEEP_ALIVE && length == Frame.NONCE_BYTES) {
      if (phase == Phase.OPEN && from.equals(udpAddress)) {
        sendDatagram(from, Frame.KEEP_ALIVE, Frame.NO_FIELDS, 0, 0); // UDP works both ways
      }
    } else {
      network.counters.malformedDatagrams.incrementAndGet();
    }
  }

  private void readAnswer(InetSocketAddress from, long answered, long now) {
    if (answered == nonce && from.equals(udpAddress)) {
      if (advance(Phase.CHALLENGED, Phase.OPEN, now)) {
        network.opened(this, udpAddress, link);
      }
    } else if (phase == Phase.OPEN && answered == newNonce && from.equals(newAddress)) {
      InetSocketAddress before = udpAddress;
      udpAddress = newAddress;
      newAddress = null;
      network.moved(this, before, udpAddress);
    }
  }

  /**
   * Asks an address from which a genuine datagram came whether the client is there. Home routers
   * and phones change a client's address while it plays; but a stranger who repeats a datagram
   * faster than it travels mustn't get the answers to it.
   */
  private void challengeNewAddress(InetSocketAddress from, long now) {
    if (newAddress != null && now - newSince < CHALLENGE_NANOS) {
      return;
    }
    if (!from.equals(newAddress)) {
      newAddress = from;
      newNonce = network.random.nextLong();
    }
    newSince = now;
    challenge(from, newNonce);
  }

  boolean openLink() {
    return link.open();
  }
}
