package carom.net.frame;

import carom.net.protocol.ServerMessage;
import carom.net.transport.MessageCodec;
import java.nio.ByteBuffer;

/**
 * Client's end of a framed link. It reads frames, follows the steps of the handshake and words the
 * reasons of failures. A subclass drives the sockets and calls it on one thread.
 */
public abstract class ClientEnd extends FramedLink {
  /** Largest number of bytes that wait for TCP to write them. */
  protected static final int WRITE_BUFFER_BYTES = 16 * 1_024;

  private static final int UNREAD_MESSAGES = 1_024;
  private static final int UNREAD_DATAGRAMS = 512;
  private static final long DATAGRAM_SILENCE_NANOS = 1_000_000_000L;
  private static final long IDLE_NANOS = 10_000_000_000L;

  private final String host;
  private final int tcpPort;
  private final int udpPort;
  private final MessageCodec codec;
  private final long connectNanos;
  private final long start = System.nanoTime();

  private int id;
  private long token;
  private boolean tcpRegistered;
  private boolean udpRegistered;
  private boolean challenged;
  private long lastFrame = start;
  private volatile long lastDatagramOut = start;
  private volatile boolean disconnected;

  /**
   * Creates a link in {@code CONNECTING}. The subclass opens the sockets.
   *
   * @param codec codec of the messages
   * @param host name or address of the server
   * @param tcpPort the server's TCP port, 1..65,535
   * @param udpPort the server's UDP port, 1..65,535
   * @param connectMillis time limit for connecting, ms
   * @throws IllegalArgumentException when a port is outside its range
   */
  protected ClientEnd(
      MessageCodec codec, String host, int tcpPort, int udpPort, int connectMillis) {
    super(codec, UNREAD_MESSAGES, UNREAD_DATAGRAMS);
    this.codec = codec;
    this.host = host;
    this.tcpPort = checkedPort("tcpPort", tcpPort);
    this.udpPort = checkedPort("udpPort", udpPort);
    connectNanos = connectMillis * 1_000_000L;
  }

  private static int checkedPort(String name, int port) {
    if (port < 1 || port > 65_535) {
      throw new IllegalArgumentException(name + "=" + port + " must be from 1 to 65535");
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

  /** Returns the server's port for datagrams. */
  protected final int udpPort() {
    return udpPort;
  }

  /**
   * Returns the server's number for this connection. It is valid once {@link #isTcpRegistered} is
   * true.
   */
  protected final int id() {
    return id;
  }

  /**
   * Returns the token that proves to the server that a datagram comes from this client. It is valid
   * once {@link #isTcpRegistered} is true.
   */
  protected final long token() {
    return token;
  }

  /** Returns whether the server has sent a frame of the Carom protocol. */
  protected final boolean isTcpRegistered() {
    return tcpRegistered;
  }

  /** Sends a frame's tag and fields by UDP. Returns false if this end dropped it. */
  protected abstract boolean transmitDatagram(byte tag, byte[] bytes, int offset, int length);

  @Override
  protected final boolean transmitDatagram(byte[] bytes, int offset, int length) {
    return transmitDatagram(Frame.DATAGRAM, bytes, offset, length);
  }

  @Override
  public String remote() {
    return host + ":" + tcpPort;
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

  /** Reads a frame from its tag to its end and returns the tag. */
  protected final byte readFrame(ByteBuffer buffer) {
    lastFrame = System.nanoTime();
    byte tag = buffer.get();
    int length = buffer.remaining();
    switch (tag) {
      case Frame.REGISTER_TCP -> {
        id = buffer.getInt();
        token = buffer.getLong();
        tcpRegistered = true;
      }
      case Frame.REGISTER_UDP, Frame.KEEP_ALIVE -> {}
      case Frame.MESSAGE -> readMessage(buffer, length);
      case Frame.BYE -> {
        tcpRegistered = true; // it is a Carom server, whatever comes next
        String text = Frame.byeText(buffer);
        lose(text.isEmpty() ? "the server closed the connection" : text);
      }
      default ->
          lose(tcpRegistered ? "the server sent an unknown frame (tag=" + tag + ")" : notCarom());
    }
    return tag;
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

  /** Reads a datagram from its tag on. */
  protected final void readDatagram(ByteBuffer buffer) {
    int length = buffer.remaining();
    byte tag = length == 0 ? 0 : buffer.get();
    if (tag == Frame.DATAGRAM && length > 1 && length <= 1 + Frame.MAX_PAYLOAD_BYTES) {
      receiveDatagram(buffer, System.nanoTime());
    } else if (tag == Frame.CHALLENGE && length == Frame.NONCE_BYTES) {
      byte[] nonce = Frame.nonce(buffer.getLong());
      transmitDatagram(Frame.ANSWER, nonce, 0, nonce.length);
      challenged = true;
      openWhenReady();
    } else {
      counters().malformed.incrementAndGet();
    }
  }

  /** Records that the server knows this client's UDP address. */
  protected final void udpRegistered() {
    udpRegistered = true;
    openWhenReady();
  }

  /** Returns whether the server knows this client's UDP address. */
  protected final boolean isUdpRegistered() {
    return udpRegistered;
  }

  private void openWhenReady() {
    if (udpRegistered && challenged) {
      open();
    }
  }

  /**
   * Closes a link that takes too long to connect or is silent too long. It also sends keep-alive
   * datagrams, so that routers keep their address translation.
   */
  protected final void checkDeadlines(long now) {
    if (state() == State.CONNECTING) {
      if (now - start > connectNanos && tcpRegistered) {
        lose(stuck());
      }
    } else if (now - lastFrame > IDLE_NANOS) {
      lose("nothing heard from the server for " + IDLE_NANOS / 1_000_000_000L + " s");
    } else if (now - lastDatagramOut > DATAGRAM_SILENCE_NANOS) {
      transmitDatagram(Frame.KEEP_ALIVE, Frame.NO_FIELDS, 0, 0);
    }
  }

  /** Returns whether connecting has taken longer than its limit. */
  protected final boolean isLate(long now) {
    return now - start > connectNanos;
  }

  /**
   * Returns the reason for a connection that ended without one. A server that waits in vain for
   * datagrams closes without a word.
   */
  protected final String gone() {
    boolean waited = state() == State.CONNECTING && tcpRegistered;
    return waited ? stuck() : "the server closed the connection";
  }

  private String stuck() {
    return udpRegistered
        ? "server reachable, but its answers from UDP port " + udpPort + " are blocked"
        : blocked();
  }

  /** Returns the reason for blocked datagrams. */
  protected final String blocked() {
    return "server reachable by TCP, but UDP port " + udpPort + " is blocked";
  }

  /** Returns the reason for an answer by something other than a Carom server. */
  protected final String notCarom() {
    return "something answers at " + remote() + ", but it isn't a Carom server";
  }

  /** Returns the reason for a missing answer. */
  protected final String noAnswer() {
    return "no server answers at " + remote() + ": is it running, and are address and port right?";
  }

  /** Returns the reason for a host name without an address. */
  protected final String unknownHost() {
    return "unknown host " + host + ": check the address";
  }

  /** Returns the reason for a missing route to the host. */
  protected final String noRoute() {
    return "no route to " + remote() + ": check the address and your network";
  }
}
