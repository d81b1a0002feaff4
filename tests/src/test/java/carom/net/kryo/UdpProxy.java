package carom.net.kryo;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.DatagramChannel;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.LockSupport;

/** A home router between one client and a server, whose address the server sees. */
final class UdpProxy implements AutoCloseable {
  /** What the client has sent, newest last. */
  final List<byte[]> sent = new CopyOnWriteArrayList<>();

  private final DatagramChannel inside = open();
  private final SocketAddress server;
  private final Thread thread = new Thread(this::run, "udp-proxy");
  private volatile DatagramChannel outside = open();
  private volatile SocketAddress client;
  private volatile boolean deaf;
  private volatile boolean closed;

  UdpProxy(int serverPort) throws IOException {
    server = new InetSocketAddress(Network.HOST, serverPort);
    inside.bind(new InetSocketAddress(Network.HOST, 0));
    thread.start();
  }

  private static DatagramChannel open() {
    try {
      DatagramChannel channel = DatagramChannel.open();
      channel.configureBlocking(false);
      return channel;
    } catch (IOException x) {
      throw new UncheckedIOException(x);
    }
  }

  int port() {
    return inside.socket().getLocalPort();
  }

  /** Sends the client's datagrams from another port from now on, and loses those to the old. */
  void rebind() throws IOException {
    DatagramChannel before = outside;
    outside = open();
    before.close();
  }

  /** Does as {@link #rebind} does, and sends from another host of this machine. */
  void rebind(String host) throws IOException {
    DatagramChannel before = outside;
    DatagramChannel next = open();
    next.bind(new InetSocketAddress(host, 0));
    outside = next;
    before.close();
  }

  /** Loses what the server sends to the client from now on. */
  void deafen() {
    deaf = true;
  }

  /** Sends bytes to the server as if they came from the client. */
  void inject(byte[] bytes) throws IOException {
    outside.send(ByteBuffer.wrap(bytes), server);
  }

  private void run() {
    ByteBuffer buffer = ByteBuffer.allocate(2_000);
    while (!closed) {
      try {
        for (SocketAddress from; (from = inside.receive(buffer.clear())) != null; ) {
          client = from;
          sent.add(Arrays.copyOf(buffer.array(), buffer.position()));
          outside.send(buffer.flip(), server);
        }
        while (outside.receive(buffer.clear()) != null) {
          if (client != null && !deaf) {
            inside.send(buffer.flip(), client);
          }
        }
        LockSupport.parkNanos(200_000);
      } catch (ClosedChannelException x) {
        LockSupport.parkNanos(200_000); // another port is there at once
      } catch (IOException x) {
        throw new UncheckedIOException(x);
      }
    }
  }

  @Override
  public void close() throws IOException {
    closed = true;
    try {
      thread.join();
    } catch (InterruptedException x) {
      throw new AssertionError(x);
    }
    inside.close();
    outside.close();
  }
}
