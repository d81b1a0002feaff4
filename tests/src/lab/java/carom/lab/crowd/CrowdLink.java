package carom.lab.crowd;

import carom.net.frame.ClientEnd;
import carom.net.frame.Frame;
import carom.net.frame.Trust;
import carom.net.kryo.KryoMessageCodec;
import carom.net.seal.StreamSeal;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.NoRouteToHostException;
import java.net.PortUnreachableException;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;

/**
 * One client of a {@link CrowdTransport}: two sockets that the transport's thread reads and any
 * thread writes. Speaks the frames of {@link Frame} without KryoNet's client.
 */
final class CrowdLink extends ClientEnd {
  private static final long KEEP_ALIVE_NANOS = Frame.KEEP_ALIVE_MILLIS * 1_000_000L;

  private final ByteBuffer frames =
      ByteBuffer.allocate(Frame.LENGTH_BYTES + Frame.CLIENT_BUFFER_BYTES);
  private final ByteBuffer unsent = ByteBuffer.allocate(WRITE_BUFFER_BYTES); // guards the writing
  private final Selector selector;
  private final ByteBuffer datagram =
      ByteBuffer.allocate(Frame.MAX_DATAGRAM_BYTES); // guards its writing
  private volatile SocketChannel tcp;
  private volatile DatagramChannel udp;
  private volatile SelectionKey tcpKey;

  // the transport's thread
  private long keepAliveAt;
  private long closedSince;

  CrowdLink(
      KryoMessageCodec codec,
      Trust trust,
      String host,
      int tcpPort,
      int udpPort,
      int connectMillis,
      Selector selector) {
    super(codec, trust, host, tcpPort, udpPort, connectMillis);
    this.selector = selector;
  }

  /**
   * Opens the sockets. The transport's thread, as for the methods below unless they say otherwise.
   */
  void begin() {
    try {
      InetSocketAddress address = new InetSocketAddress(host(), tcpPort());
      if (address.isUnresolved()) {
        lose("unknown host " + host() + ": check the address");
        return;
      }
      tcp = SocketChannel.open();
      tcp.configureBlocking(false);
      tcp.socket().setTcpNoDelay(true);
      tcpKey = tcp.register(selector, SelectionKey.OP_CONNECT, this);
      if (tcp.connect(address)) {
        connected();
      }
    } catch (IOException | RuntimeException x) {
      lose("can't connect to " + remote() + ": " + x.getMessage());
    }
  }

  private void connected() {
    tcpKey.interestOps(SelectionKey.OP_READ);
    keepAliveAt = System.nanoTime() + KEEP_ALIVE_NANOS;
  }

  /** Handles a socket that is ready. */
  void ready(SelectionKey key, ByteBuffer datagramIn) {
    if (isDisconnected()) {
      return;
    }
    try {
      if (key.channel() == udp) {
        // One datagram per selection; the next selection finds what still waits.
        if (udp.read(datagramIn.clear()) >= 0) {
          readDatagram(datagramIn.flip());
        }
        return;
      }
      if (key.isConnectable() && tcp.finishConnect()) {
        connected();
      }
      if (key.isWritable()) {
        flush();
      }
      if (key.isReadable()) {
        readFrames();
      }
    } catch (PortUnreachableException x) {
      udpRefused();
    } catch (NoRouteToHostException x) {
      lose(noRoute());
    } catch (IOException x) {
      lose(tcp.isConnected() ? (isTcpRegistered() ? gone() : notCarom()) : noAnswer());
    } catch (RuntimeException x) {
      lose("the server sent an invalid frame");
    }
  }

  private void readFrames() throws IOException {
    if (tcp.read(frames) < 0) {
      lose(isTcpRegistered() ? gone() : notCarom());
      return;
    }
    frames.flip();
    while (frames.remaining() >= Frame.LENGTH_BYTES && !isDisconnected()) {
      int length = frames.getInt(frames.position());
      if (length <= 0 || length > Frame.CLIENT_BUFFER_BYTES) {
        lose(isTcpRegistered() ? "the server sent an invalid frame" : notCarom());
        return;
      }
      if (frames.remaining() - Frame.LENGTH_BYTES < length) {
        break;
      }
      frames.position(frames.position() + Frame.LENGTH_BYTES);
      int end = frames.position() + length;
      int filled = frames.limit();
      byte tag = readFrame(frames.limit(end));
      frames.limit(filled).position(end);
      if (tag == Frame.REGISTER_TCP) {
        openDatagrams();
      } else if (tag == Frame.REGISTER_UDP) {
        udpRegistered();
      }
    }
    frames.compact();
  }

  private void openDatagrams() throws IOException {
    if (udp == null && !isDisconnected()) {
      udp = DatagramChannel.open();
      udp.configureBlocking(false);
      InetSocketAddress server = (InetSocketAddress) tcp.getRemoteAddress();
      udp.connect(new InetSocketAddress(server.getAddress(), udpPort()));
      udp.register(selector, SelectionKey.OP_READ, this);
      registerUdp(System.nanoTime());
    }
  }

  /** Checks deadlines. Called about 20 times a second. */
  void sweep(long now) {
    if (state() == State.CLOSED) {
      closedSince = closedSince == 0 ? now : closedSince;
      if (now - closedSince > Frame.LINGER_NANOS) {
        lose("closed"); // the server took its time to answer BYE
      }
      return;
    }
    if (!isTcpRegistered()) {
      if (isLate(now)) {
        lose(tcp.isConnected() ? notCarom() : noAnswer());
      }
      return;
    }
    registerUdp(now);
    if (now - keepAliveAt >= 0) {
      keepAliveAt = now + KEEP_ALIVE_NANOS;
      if (isUdpRegistered()) { // before that, a server accepts no message over TCP
        transmit(new Frame.Payload().set(Frame.KEEP_ALIVE, Frame.NO_FIELDS, 0, 0));
      }
    }
    checkDeadlines(now);
  }

  /** Closes the sockets in any state. */
  void release() {
    lose("connection lost");
    try {
      if (tcp != null) {
        tcp.close();
      }
      if (udp != null) {
        udp.close();
      }
    } catch (IOException x) {
      finish("connection lost: " + x.getMessage());
    }
  }

  @Override
  protected boolean transmit(Frame.Payload frame) {
    synchronized (unsent) {
      StreamSeal seal = streamSeal();
      int extra = seal == null ? 0 : StreamSeal.EXTRA_BYTES;
      int plain = frame.tcpBytes() - Frame.LENGTH_BYTES;
      if (unsent.remaining() < Frame.LENGTH_BYTES + plain + extra) {
        lose("the server doesn't read what it is sent");
        return false;
      }
      unsent.putInt(plain + extra);
      int start = unsent.position();
      frame.write(unsent);
      if (seal != null) {
        seal.seal(unsent.array(), start, plain);
        unsent.position(start + plain + extra);
      }
      try {
        flush();
        return true;
      } catch (IOException | RuntimeException x) {
        lose("connection lost");
        return false;
      }
    }
  }

  private void flush() throws IOException {
    synchronized (unsent) {
      unsent.flip();
      try {
        tcp.write(unsent);
      } finally {
        unsent.compact();
      }
      boolean waits = unsent.position() > 0;
      int ops = SelectionKey.OP_READ | (waits ? SelectionKey.OP_WRITE : 0);
      if (tcpKey.interestOps() != ops) {
        tcpKey.interestOps(ops);
        selector.wakeup();
      }
    }
  }

  @Override
  protected boolean isWritable() {
    synchronized (unsent) {
      return unsent.position() == 0;
    }
  }

  @Override
  protected boolean transmitDatagram(byte tag, byte[] bytes, int offset, int length) {
    DatagramChannel channel = udp;
    if (channel == null || isDisconnected()) {
      return false;
    }
    synchronized (datagram) {
      datagram.clear().put(tag).put(bytes, offset, length).flip();
      try {
        datagramLeft();
        return channel.write(datagram) > 0;
      } catch (IOException | RuntimeException x) {
        return false; // the datagram is lost; if the link is broken, TCP will tell
      }
    }
  }

  @Override
  protected void disconnect(State before, String reason) {
    if (before != State.OPEN || !transmit(Frame.bye(reason))) {
      lose(reason);
      selector.wakeup();
    }
  }
}
