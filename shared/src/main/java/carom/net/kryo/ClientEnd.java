package carom.net.kryo;

import carom.net.protocol.ServerMessage;
import java.nio.ByteBuffer;

/**
 * A client's end of a link: what it reads, how far it has come on its way in, and in which words it
 * fails. Whoever drives the sockets calls it on one thread.
 */
abstract class ClientEnd extends KryoLink {
  static final int WRITE_BUFFER_BYTES = 16 * 1_024;
  private static final int UNREAD_MESSAGES = 1_024;
  private static final int UNREAD_DATAGRAMS = 512;
  private static final long DATAGRAM_SILENCE_NANOS = 1_000_000_000L;
  private static final long IDLE_NANOS = 10_000_000_000L;

  final String host;
  final int tcpPort;
  final int udpPort;
  private final KryoMessageCodec codec;
  private final long connectNanos;
  private final long start = System.nanoTime();

  /** Number of the connection at the server, once {@link #tcpRegistered}. */
  int id;

  /** Proves to the server that a datagram comes from this client, once {@link #tcpRegistered}. */
  long token;

  /** Whether the server has sent its first frame: it is one of ours. */
  boolean tcpRegistered;

  private boolean udpRegistered;
  private boolean challenged;
  private long lastFrame = start;
  private volatile long lastDatagramOut = start;
  private volatile boolean disconnected;

  ClientEnd(KryoMessageCodec codec, String host, int tcpPort, int udpPort, int connectMillis) {
    super(codec, UNREAD_MESSAGES, UNREAD_DATAGRAMS);
    this.codec = codec;
    this.host = host;
    this.tcpPort = tcpPort;
    this.udpPort = udpPort;
    connectNanos = connectMillis * 1_000_000L;
  }

  /** Puts any frame's tag and fields on the wire by UDP; false when they are lost right here. */
  abstract boolean transmitDatagram(byte tag, byte[] bytes, int offset, int length);

  @Override
  final boolean transmitDatagram(byte[] bytes, int offset, int length) {
    return transmitDatagram(Frame.DATAGRAM, bytes, offset, length);
  }

  @Override
  public String remote() {
    return host + ":" + tcpPort;
  }

  /** A datagram has left. Any thread. */
  final void datagramLeft() {
    lastDatagramOut = System.nanoTime();
  }

  /** The sockets are of no use any more, and the link is over unless it was already. Any thread. */
  final void lose(String reason) {
    finish(reason);
    disconnected = true;
  }

  /** Whether the sockets are of no use any more. */
  final boolean isDisconnected() {
    return disconnected;
  }

  /** Reads a frame from its tag on, to the end; answers the tag. */
  final byte readFrame(ByteBuffer buffer) {
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
    ServerMessage message =
        codec.decodeFromServer(buffer.array(), buffer.arrayOffset() + buffer.position(), length);
    if (message == null) {
      counters().malformed.incrementAndGet();
      lose("the server sent a message that can't be read");
    } else if (!receiveMessage(message, length)) {
      lose("more than " + UNREAD_MESSAGES + " unread messages");
    }
  }

  final void readDatagram(ByteBuffer buffer) {
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

  /** The server knows our UDP address. */
  final void udpRegistered() {
    udpRegistered = true;
    openWhenReady();
  }

  /** Whether the server knows our UDP address. */
  final boolean isUdpRegistered() {
    return udpRegistered;
  }

  private void openWhenReady() {
    if (udpRegistered && challenged) {
      open();
    }
  }

  /** Ends what takes too long, and keeps the address translation of routers alive. */
  final void checkDeadlines(long now) {
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

  /** Whether connecting takes too long. */
  final boolean isLate(long now) {
    return now - start > connectNanos;
  }

  /**
   * Why the connection ended; a server that waits in vain for datagrams gives up without a word.
   */
  final String gone() {
    boolean waited = state() == State.CONNECTING && tcpRegistered;
    return waited ? stuck() : "the server closed the connection";
  }

  private String stuck() {
    return udpRegistered
        ? "server reachable, but its answers from UDP port " + udpPort + " are blocked"
        : blocked();
  }

  final String blocked() {
    return "server reachable by TCP, but UDP port " + udpPort + " is blocked";
  }

  final String notCarom() {
    return "something answers at " + remote() + ", but it isn't a Carom server";
  }

  final String noAnswer() {
    return "no server answers at " + remote() + ": is it running, and are address and port right?";
  }

  final String unknownHost() {
    return "unknown host " + host + ": check the address";
  }

  final String noWay() {
    return "no way to " + remote() + ": check the address and your network";
  }
}
