package carom.net.frame;

import carom.net.admission.WorkProof;
import carom.net.protocol.ServerMessage;
import carom.net.seal.DatagramOpener;
import carom.net.seal.DatagramSealer;
import carom.net.seal.Encryption;
import carom.net.seal.ExchangeKey;
import carom.net.seal.KeyExchange;
import carom.net.seal.LinkKeys;
import carom.net.seal.ServerKey;
import carom.net.seal.StreamSeal;
import carom.net.transport.MessageCodec;
import java.nio.ByteBuffer;
import java.security.GeneralSecurityException;

/**
 * Client's end of a framed link. It reads frames, follows the steps of the handshake, keeps the
 * link's keys and words the reasons of failures. A subclass drives the sockets and calls it on one
 * thread, which also computes the keys (about 0.6 ms).
 */
public abstract class ClientEnd extends FramedLink {
  /** Largest number of bytes that wait for TCP to write them. */
  protected static final int WRITE_BUFFER_BYTES = 16 * 1_024;

  private static final int UNREAD_MESSAGES = 1_024;
  private static final int UNREAD_DATAGRAMS = 512;
  private static final long DATAGRAM_SILENCE_NANOS = 1_000_000_000L;
  private static final long PROBE_NANOS = 500_000_000L;

  /** Time that datagrams have to show that they pass, in addition to two round trips, ns. */
  private static final long UDP_PATIENCE_NANOS = 2_000_000_000L;

  /** Round trips that a step of connecting may take, in addition to its time limit. */
  private static final int STEP_ROUND_TRIPS = 4;

  private static final long IDLE_NANOS = 10_000_000_000L;
  private static final long REGISTER_NANOS = 100_000_000L;
  private static final String USED_UP = "the keys of this connection are used up";

  private final String host;
  private final int tcpPort;
  private final int udpPort;
  private final MessageCodec codec;
  private final Trust trust;
  private final long stepNanos;
  private final Object streaming = new Object();
  private final long start = System.nanoTime();

  // used by the subclass's thread
  private byte[] greeting;
  private int id;
  private long token;
  private int toldUdpPort;
  private byte[] serverKey;
  private int workBits;
  private long solution;
  private long roundTripNanos; // or a little more, known with the greeting
  private long stepSince = start;

  /** Fields that make a datagram as long as the challenge that may answer it. */
  private static final byte[] PADDING = new byte[Frame.NONCE_BYTES];

  private boolean streams; // UDP is blocked, and TCP carries the datagrams
  private long probedAt = start;
  private KeyExchange.Offer offer;
  private boolean tcpRegistered;
  private boolean udpRegistered;
  private int registrations;
  private long registeredAt;
  private final byte[] received = new byte[Frame.MAX_DATAGRAM_BYTES + 1];
  private final ByteBuffer opened = ByteBuffer.wrap(received);

  private final Object sealing = new Object();
  private volatile LinkKeys keys; // its sealer of datagrams is guarded by the lock above
  private long lastFrame = start;
  private volatile long lastDatagramOut = start;
  private volatile boolean disconnected;
  private volatile boolean udpRefused;
  private volatile boolean mayPass;
  private volatile String fingerprint = ""; // proven

  /**
   * Creates a link in {@code CONNECTING}. The subclass opens the sockets.
   *
   * @param codec codec of the messages
   * @param trust which servers may be trusted
   * @param host name or address of the server
   * @param tcpPort the server's TCP port, 1..65,535
   * @param udpPort the server's UDP port, 1..65,535, or 0 for the one that the server tells
   * @param stepMillis time limit for each step of connecting, ms, on a line without delay
   * @throws IllegalArgumentException when a port is outside its range
   */
  protected ClientEnd(
      MessageCodec codec, Trust trust, String host, int tcpPort, int udpPort, int stepMillis) {
    super(codec, UNREAD_MESSAGES, UNREAD_DATAGRAMS);
    this.codec = codec;
    this.trust = trust;
    this.host = host;
    this.tcpPort = checkedPort("tcpPort", tcpPort, 1);
    this.udpPort = checkedPort("udpPort", udpPort, 0);
    stepNanos = stepMillis * 1_000_000L;
  }

  private static int checkedPort(String name, int port, int least) {
    if (port < least || port > 65_535) {
      throw new IllegalArgumentException(
          name + "=" + port + " must be from " + least + " to 65535");
    }
    return port;
  }

  /** Returns the name or address of the server. */
  protected final String host() {
    return host;
  }

  /** Returns the server's port for messages. */
  protected final int tcpPort() {
    return tcpPort;
  }

  /**
   * Returns the server's port for datagrams. It is valid once {@link #isTcpRegistered} is true,
   * because a server tells it over TCP.
   */
  protected final int udpPort() {
    return udpPort == 0 ? toldUdpPort : udpPort;
  }

  /**
   * Returns the server's number for this connection. It is valid once {@link #isTcpRegistered} is
   * true.
   */
  protected final int id() {
    return id;
  }

  /**
   * Tells the server this link's UDP address, again and again until the server confirms it, and
   * from the keys on until its challenge has come. Call it once {@link #isTcpRegistered} is true
   * and the UDP socket is open, about 20 times a second.
   */
  protected final void registerUdp(long now) {
    boolean challenged = keys != null;
    if (state() != State.CONNECTING || (udpRegistered && !challenged)) {
      return;
    }
    long pause = challenged ? Math.max(REGISTER_NANOS, (now - stepSince) / 2) : REGISTER_NANOS;
    long last = challenged ? Math.max(registeredAt, stepSince) : registeredAt;
    if (registrations > 0 && now - last < pause) {
      return;
    }
    registrations++;
    registeredAt = now;
    byte[] fields = Frame.registration(id, token, solution);
    transmitDatagram(Frame.REGISTER_UDP, fields, 0, fields.length);
  }

  /** Returns whether the server has sent a frame of the Carom protocol. */
  protected final boolean isTcpRegistered() {
    return tcpRegistered;
  }

  /**
   * Sends a tag and bytes by UDP as they are. Returns false if this end dropped them. Datagrams are
   * sealed before; only REGISTER_UDP isn't.
   */
  protected abstract boolean transmitDatagram(byte tag, byte[] bytes, int offset, int length);

  @Override
  protected final boolean transmitDatagram(byte[] bytes, int offset, int length) {
    long now = System.nanoTime();
    return path.isOverTcp(now)
        ? path.isFree(now) && stream(bytes, offset, length)
        : transmitSealed(Frame.DATAGRAM, bytes, offset, length);
  }

  private boolean stream(byte[] bytes, int offset, int length) {
    synchronized (streaming) { // heads must leave in the order of their counts
      return isWritable() && transmit(Frame.streamed(path, bytes, offset, length));
    }
  }

  /** Returns whether nothing waits to be written by TCP. Any thread may call it. */
  protected abstract boolean isWritable();

  private boolean transmitSealed(byte tag, byte[] fields, int offset, int length) {
    LinkKeys current = keys;
    if (current == null) {
      return false;
    }
    DatagramSealer sealer = current.datagramsOut();
    synchronized (sealing) {
      if (sealer.isUsedUp()) {
        lose(USED_UP);
        return false;
      }
      int sealed = sealer.seal(tag, fields, offset, length);
      return transmitDatagram(tag, sealer.bytes(), 1, sealed - 1);
    }
  }

  /**
   * Returns the seal of what this end sends by TCP, or null while that is in the clear. Use it
   * under the lock of the stream.
   */
  protected final StreamSeal streamSeal() {
    LinkKeys current = keys;
    return current == null ? null : current.streamOut();
  }

  @Override
  public String remote() {
    return host + ":" + tcpPort;
  }

  @Override
  public byte[] binding() {
    LinkKeys current = keys;
    return current == null ? null : current.binding();
  }

  @Override
  public String serverFingerprint() {
    return fingerprint;
  }

  /** Records that a datagram has left. Any thread may call it. */
  protected final void datagramLeft() {
    lastDatagramOut = System.nanoTime();
  }

  /**
   * Marks the sockets for closing and closes the link if it isn't closed. Any thread may call it.
   */
  public final void lose(String reason) {
    finish(reason);
    disconnected = true;
  }

  /** Returns whether the sockets are to be closed. */
  public final boolean isDisconnected() {
    return disconnected;
  }

  /**
   * Reads a frame from its tag to its end and returns the tag, or 0 for a frame that isn't genuine.
   * It may lower the buffer's limit.
   */
  protected final byte readFrame(ByteBuffer buffer) {
    lastFrame = System.nanoTime();
    if (keys != null) {
      int start = buffer.arrayOffset() + buffer.position();
      int length = keys.streamIn().open(buffer.array(), start, buffer.remaining());
      if (length < 1) {
        lose("the connection was tampered with: a frame isn't genuine");
        return 0;
      }
      buffer.limit(buffer.position() + length);
    }
    byte tag = buffer.get();
    int length = buffer.remaining();
    switch (tag) {
      case Frame.REGISTER_TCP -> readGreeting(buffer);
      case Frame.REGISTER_UDP, Frame.KEEP_ALIVE -> {}
      case Frame.KEY_ANSWER -> finishKeys(buffer);
      case Frame.MESSAGE -> readMessage(buffer, length);
      case Frame.STREAMED -> readStreamed(buffer);
      case Frame.BYE -> {
        tcpRegistered = true; // it is a Carom server, whatever comes next
        mayPass = state() == State.CONNECTING; // a server that plays says more than this
        String text = Frame.byeText(buffer);
        lose(text.isEmpty() ? "the server closed the connection" : text);
      }
      default ->
          lose(tcpRegistered ? "the server sent an unknown frame (tag=" + tag + ")" : notCarom());
    }
    return tag;
  }

  private void readGreeting(ByteBuffer buffer) {
    if (greeting != null || buffer.remaining() != Frame.GREETING_BYTES) {
      lose(tcpRegistered ? "the server greeted twice" : notCarom() + " of this version");
      return;
    }
    greeting = new byte[Frame.GREETING_BYTES];
    buffer.get(greeting);
    ByteBuffer fields = ByteBuffer.wrap(greeting);
    id = fields.getInt();
    token = fields.getLong();
    toldUdpPort = Short.toUnsignedInt(fields.getShort());
    byte mode = fields.get();
    workBits = fields.get();
    serverKey = new byte[ExchangeKey.BYTES];
    fields.get(serverKey);
    tcpRegistered = true;
    stepSince = System.nanoTime();
    roundTripNanos = stepSince - start;
    path.roundTrip(roundTripNanos);
    if (workBits < 0 || workBits > WorkProof.MAX_BITS) {
      lose(
          "the server demands too much work: workBits="
              + workBits
              + " must be in 0.."
              + WorkProof.MAX_BITS);
      return;
    }
    if (mode != trust.encryption().code()) {
      lose(
          trust.encryption() == Encryption.ON
              ? "the server doesn't encrypt, or somebody in between pretends so; if you trust the"
                  + " network, connect with --encryption off"
              : "the server encrypts; connect without --encryption off");
      return;
    }
    String problem =
        trust.encryption() == Encryption.OFF
            ? null // without encryption the server proves nothing
            : trust.servers().problem(remote(), ServerKey.fingerprint(serverKey));
    if (problem != null) {
      lose(problem);
      return;
    }
    solution = new WorkProof().solve(id, token, workBits);
  }

  private void offerKey() {
    try {
      offer = new KeyExchange.Offer(trust.encryption(), serverKey, greeting);
    } catch (GeneralSecurityException x) {
      lose("the connection was tampered with: the server's key is none");
      return;
    }
    byte[] bytes = offer.bytes();
    transmit(new Frame.Payload().set(Frame.KEY_OFFER, bytes, 0, bytes.length));
  }

  private void finishKeys(ByteBuffer buffer) {
    if (offer == null || buffer.remaining() != KeyExchange.ANSWER_BYTES) {
      lose("the server sent an invalid answer to the exchange of keys");
      return;
    }
    byte[] answer = new byte[KeyExchange.ANSWER_BYTES];
    buffer.get(answer);
    try {
      keys = offer.finish(answer, id, Frame.MAX_PAYLOAD_BYTES);
    } catch (GeneralSecurityException x) {
      lose("the connection was tampered with: " + x.getMessage());
      return;
    }
    offer = null;
    if (trust.encryption() == Encryption.ON) {
      fingerprint = ServerKey.fingerprint(serverKey);
      trust.servers().remember(remote(), fingerprint);
    }
    stepSince = System.nanoTime();
    transmit(new Frame.Payload().set(Frame.KEY_CONFIRM, Frame.NO_FIELDS, 0, 0));
    if (streams) {
      open();
    }
  }

  /**
   * Asks the server to carry datagrams over TCP, as none pass by UDP. UDP goes on being tried, and
   * takes over when it works.
   */
  private void useStream(long now) {
    streams = true;
    stepSince = now;
    long work = new WorkProof().solve(id, token, Frame.streamWorkBits(workBits));
    byte[] fields = ByteBuffer.allocate(Frame.SOLUTION_BYTES).putLong(work).array();
    transmit(new Frame.Payload().set(Frame.STREAM, fields, 0, fields.length));
    if (keys != null) {
      open();
    }
  }

  private void readStreamed(ByteBuffer fields) {
    long now = System.nanoTime();
    if (keys == null || !Frame.readStreamed(path, fields, now)) {
      lose("the server sent an invalid datagram over TCP");
    } else if (fields.hasRemaining()) {
      receiveDatagram(fields, now);
    }
  }

  private void readMessage(ByteBuffer buffer, int length) {
    Object message = codec.decode(buffer.array(), buffer.arrayOffset() + buffer.position(), length);
    if (!(message instanceof ServerMessage)) {
      counters().malformed.incrementAndGet();
      lose("the server sent a message that can't be read");
    } else if (!receiveMessage(message, length)) {
      lose("more than " + UNREAD_MESSAGES + " unread messages");
    }
  }

  /** Reads a datagram from its tag on. One that isn't genuine changes nothing. */
  protected final void readDatagram(ByteBuffer buffer) {
    int length = buffer.remaining();
    LinkKeys current = keys;
    if (current == null || length > Frame.MAX_DATAGRAM_BYTES) {
      counters().malformed.incrementAndGet();
      return;
    }
    buffer.get(received, 0, length);
    int fields = current.datagramsIn().open(received, length);
    if (fields == DatagramOpener.REPLAYED) {
      return; // networks duplicate datagrams
    }
    byte tag = received[0];
    if (fields >= 0) {
      path.heardByUdp(tag != Frame.CHALLENGE, System.nanoTime());
    }
    opened.limit(DatagramSealer.HEAD_BYTES + Math.max(0, fields));
    opened.position(DatagramSealer.HEAD_BYTES);
    if (tag == Frame.DATAGRAM && fields >= 1) {
      receiveDatagram(opened, System.nanoTime());
    } else if (tag == Frame.CHALLENGE && fields == Frame.NONCE_BYTES) {
      byte[] nonce = Frame.nonce(opened.getLong());
      transmitSealed(Frame.ANSWER, nonce, 0, nonce.length);
      open();
    } else if (tag != Frame.KEEP_ALIVE || fields != 0) {
      counters().malformed.incrementAndGet();
    }
  }

  /** Records that the server knows this client's UDP address, and offers a key. */
  protected final void udpRegistered() {
    if (greeting == null) {
      lose(notCarom()); // a server greets first
    } else if (!udpRegistered && state() == State.CONNECTING) {
      udpRegistered = true;
      stepSince = System.nanoTime();
      offerKey();
    }
  }

  /** Returns whether the server knows this client's UDP address. */
  protected final boolean isUdpRegistered() {
    return udpRegistered;
  }

  /** Notes that the server's machine has no such UDP port. Any thread may call it. */
  protected final void udpRefused() {
    udpRefused = true;
  }

  /**
   * Closes a link that takes too long to connect or is silent too long, and lets TCP carry the
   * datagrams if UDP doesn't. It also sends keep-alive datagrams, so that routers keep their
   * address translation and both ends know whether UDP works. Call it about 20 times a second.
   */
  protected final void checkDeadlines(long now) {
    if (state() == State.CONNECTING) {
      checkStep(now);
    } else if (now - lastFrame > IDLE_NANOS) {
      lose("nothing heard from the server for " + IDLE_NANOS / 1_000_000_000L + " s");
    } else {
      boolean asks = path.isQuiet(now) && now - probedAt > PROBE_NANOS;
      if (asks || now - lastDatagramOut > DATAGRAM_SILENCE_NANOS) {
        probedAt = now;
        transmitSealed(Frame.KEEP_ALIVE, PADDING, 0, PADDING.length);
      }
      if (path.mustSpeak(now)) {
        stream(Frame.NO_FIELDS, 0, 0);
      }
    }
  }

  /** Returns whether a step without delay has taken longer than its limit since the beginning. */
  protected final boolean isLate(long now) {
    return now - start > stepNanos;
  }

  private void checkStep(long now) {
    if (!tcpRegistered) {
      return; // the subclass has a limit for this
    }
    long waited = now - stepSince;
    boolean waitsForUdp = !udpRegistered || keys != null;
    long patience = Math.min(UDP_PATIENCE_NANOS, stepNanos / 2) + 2 * roundTripNanos;
    if (waitsForUdp && !streams && (udpRefused || waited > patience)) {
      useStream(now);
    } else if (waited > stepNanos + STEP_ROUND_TRIPS * roundTripNanos) {
      lose(stuck());
      mayPass = true;
    }
  }

  /** Notes that the reason for the end may be over in a moment. Any thread may call it. */
  protected final void mayPass(boolean may) {
    mayPass = may;
  }

  @Override
  public final boolean mayPass() {
    return mayPass;
  }

  /**
   * Returns the reason for a connection that ended without one. A server that waits in vain for
   * datagrams closes without a word.
   */
  protected final String gone() {
    boolean waited = state() == State.CONNECTING && tcpRegistered;
    mayPass |= waited;
    return waited ? stuck() : "the server closed the connection";
  }

  private String stuck() {
    if (!udpRegistered) {
      return blocked();
    }
    return keys == null || streams
        ? "the server didn't answer the exchange of keys"
        : "server reachable, but its answers from UDP port " + udpPort() + " are blocked";
  }

  /** Returns the reason for blocked datagrams. */
  private String blocked() {
    String text = "server reachable by TCP, but UDP port " + udpPort() + " is blocked";
    boolean other = tcpRegistered && toldUdpPort != udpPort();
    return other ? text + "; the server itself uses UDP port " + toldUdpPort : text;
  }

  /** Returns the reason for an answer by something other than a Carom server. */
  protected final String notCarom() {
    return "something answers at " + remote() + ", but it isn't a Carom server";
  }

  /** Returns the reason for a missing answer. */
  protected final String noAnswer() {
    return "no server answers at " + remote() + "; check that it runs, and its address and port";
  }

  /** Returns the reason for a missing route to the host. */
  protected final String noRoute() {
    return "no route to " + remote() + ": check the address and your network";
  }
}
