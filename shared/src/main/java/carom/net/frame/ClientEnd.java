package carom.net.frame;

import carom.net.protocol.ServerMessage;
import carom.net.transport.MessageCodec;
import java.nio.ByteBuffer;

/**
 * A client's end of a link: what it reads, how far it has come on its way in, and in which words it
 * fails. Whoever drives the sockets calls it on one thread.
 */
public abstract class ClientEnd extends FramedLink {
  /** What may wait to be written by TCP. */
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
   * Creates a link that is being opened; whoever drives it opens the sockets.
   *
   * @param codec of the messages
   * @param host of the server, a name or an address
   * @param tcpPort of the server, 1..65535
   * @param udpPort of the server, 1..65535
   * @param connectMillis until a server that doesn't answer is given up
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

  /** Returns the number of the connection at the server, once {@link #isTcpRegistered}. */
  protected final int id() {
    return id;
  }

  /**
   * Returns what proves to the server that a datagram comes from this client, once {@link
   * #isTcpRegistered}.
   */
  protected final long token() {
    return token;
  }

  /** Returns whether the server has sent its first frame: it is one of ours. */
  protected final boolean isTcpRegistered() {
    return tcpRegistered;
  }

  /** Puts any frame's tag and fields on the wire by UDP; false when they are lost right here. */
  protected abstract boolean transmitDatagram(byte tag, byte[] bytes, int offset, int length);

  @Override
  protected final boolean transmitDatagram(byte[] bytes, int offset, int length) {
    return transmitDatagram(Frame.DATAGRAM, bytes, offset, length);
  }

  @Override
  public String remote() {
    return host + ":" + tcpPort;
  }

  /** Notes that a datagram has left. Any thread. */
  protected final void datagramLeft() {
    lastDatagramOut = System.nanoTime();
  }

  /** Gives up the sockets, and ends the link unless it has ended already. Any thread. */
  public final void lose(String reason) {
    finish(reason);
    disconnected = true;
  }

  /** Returns whether the sockets are of no use any more. */
  public final boolean isDisconnected() {
    return disconnected;
  }

  /** Reads a frame from its tag on, to the end; answers the tag. */
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
        tcpRegistered = true; // a Carom server, whatever comes next
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

  /** Notes that the server knows our UDP address. */
  protected final void udpRegistered() {
    udpRegistered = true;
    openWhenReady();
  }

  /** Returns whether the server knows our UDP address. */
  protected final boolean isUdpRegistered() {
    return udpRegistered;
  }

  private void openWhenReady() {
    if (udpRegistered && challenged) {
      open();
    }
  }

  /** Ends what takes too long, and keeps the address translation of routers alive. */
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

  /** Returns whether connecting takes too long. */
  protected final boolean isLate(long now) {
    return now - start > connectNanos;
  }

  /**
   * Says why the connection ended; a server that waits in vain for datagrams gives up without a
   * word.
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

  /** Says that datagrams don't get through. */
  protected final String blocked() {
    return "server reachable by TCP, but UDP port " + udpPort + " is blocked";
  }

  /** Says that somebody else answers. */
  protected final String notCarom() {
    return "something answers at " + remote() + ", but it isn't a Carom server";
  }

  /** Says that nobody answers. */
  protected final String noAnswer() {
    return "no server answers at " + remote() + ": is it running, and are address and port right?";
  }

  /** Says that the host has no address. */
  protected final String unknownHost() {
    return "unknown host " + host + ": check the address";
  }

  /** Says that there is no route to the host. */
  protected final String noWay() {
    return "no way to " + remote() + ": check the address and your network";
  }
}
