package carom.net.kryo.server;

import com.esotericsoftware.kryonet.Server;
import java.io.IOException;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.net.InetSocketAddress;
import java.net.ProtocolFamily;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;

/**
 * Listens for TCP connections in the place of KryoNet's server, and hands them to it. KryoNet
 * itself keeps 50 connections that it hasn't accepted, and accepts one in each turn of its loop: a
 * flood of connections keeps everybody else's from being heard. It has no way in for another
 * listener, so this class reaches two private members of its only version. One thread.
 */
public final class Acceptor {
  /**
   * Connections that the system keeps until they are accepted; many systems keep fewer. A flood
   * that is faster than the server fills any queue: 4,096 made each wait for longer than its client
   * has patience.
   */
  private static final int BACKLOG = 1_024;

  /** Connections accepted in a turn; those that are open are served in between. */
  private static final int MOST_PER_TURN = 64;

  private final Server server;
  private final Method take;
  private final Selector selector;
  private final ServerSocketChannel channel;

  /**
   * Opens a port. The server's {@code update} returns when a connection waits.
   *
   * @param server a server without a port of its own
   * @param family of the addresses, or null for all
   * @throws IOException when the port can't be opened; nothing stays open then
   */
  public Acceptor(Server server, InetSocketAddress address, ProtocolFamily family)
      throws IOException {
    this.server = server;
    try {
      Field selectorOfServer = Server.class.getDeclaredField("selector");
      selectorOfServer.setAccessible(true);
      selector = (Selector) selectorOfServer.get(server);
      take = Server.class.getDeclaredMethod("acceptOperation", SocketChannel.class);
      take.setAccessible(true);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException("this needs KryoNet 2.22.0-RC1", e);
    }
    channel = family == null ? ServerSocketChannel.open() : ServerSocketChannel.open(family);
    try {
      channel.bind(address, BACKLOG);
      channel.configureBlocking(false);
      channel.register(selector, SelectionKey.OP_ACCEPT);
    } catch (IOException e) {
      channel.close();
      throw e;
    }
  }

  /** Returns the number of the port. */
  public int port() {
    return channel.socket().getLocalPort();
  }

  /**
   * Accepts what waits, but so many at most that the server's other work goes on.
   *
   * @throws IOException when the system gives no more connections, as it does when the process has
   *     too many open files
   */
  public void acceptWaiting() throws IOException {
    for (int i = 0; i < MOST_PER_TURN; i++) {
      SocketChannel accepted = channel.accept();
      if (accepted == null) {
        return;
      }
      try {
        take.invoke(server, accepted);
      } catch (ReflectiveOperationException e) {
        accepted.close();
        throw new IllegalStateException("KryoNet didn't take a connection", e);
      }
    }
  }

  /** Lets the server's {@code update} return at once, now or when it is called next. Any thread. */
  public void wake() {
    selector.wakeup();
  }

  /** Closes the port. The system turns away what waits. */
  public void close() throws IOException {
    channel.close();
    selector.selectNow(); // the system closes a port only when no selector knows it
  }
}
