package carom.net.kryo.server;

import carom.net.transport.AddressFamily;
import com.esotericsoftware.kryonet.Server;
import java.io.IOException;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ProtocolFamily;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.List;

/**
 * Listens for TCP connections, at one or more addresses, in the place of KryoNet's server, and
 * hands them to it. KryoNet itself keeps 50 connections that it hasn't accepted, and accepts one in
 * each turn of its loop: a flood of connections keeps everybody else's from being heard. It has no
 * way in for another listener, so this class reaches two private members of its only version. One
 * thread.
 */
final class Acceptor {
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
  private final List<ServerSocketChannel> channels = new ArrayList<>();
  private final ProxyRule proxies;
  private final ProxyGate gate; // null without proxies
  private InetSocketAddress client;

  /**
   * Opens a port that no proxy is before.
   *
   * @throws IOException when the port can't be opened; nothing stays open then
   */
  public Acceptor(Server server, List<InetAddress> addresses, int port) throws IOException {
    this(server, addresses, port, ProxyRule.NONE);
  }

  /**
   * Opens a port. The server's {@code update} returns when a connection waits.
   *
   * @param server a server without a port of its own
   * @param addresses of this machine; null stands for all
   * @param port 0..65,535; 0 takes a free one, which is the same at all addresses
   * @param proxies which connections come by proxies
   * @throws IOException when the port can't be opened; nothing stays open then
   */
  public Acceptor(Server server, List<InetAddress> addresses, int port, ProxyRule proxies)
      throws IOException {
    this.proxies = proxies;
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
    try {
      for (InetAddress address : addresses) {
        ProtocolFamily family = AddressFamily.of(address);
        ServerSocketChannel channel =
            family == null ? ServerSocketChannel.open() : ServerSocketChannel.open(family);
        channels.add(channel);
        int number = channels.size() == 1 ? port : port();
        channel.bind(new InetSocketAddress(address, number), BACKLOG);
        channel.configureBlocking(false);
        channel.register(selector, SelectionKey.OP_ACCEPT);
      }
    } catch (IOException e) {
      closeChannels();
      throw e;
    }
    gate = proxies.equals(ProxyRule.NONE) ? null : new ProxyGate(proxies, selector::wakeup);
  }

  /** Returns the number of the port. */
  public int port() {
    return channels.get(0).socket().getLocalPort();
  }

  /**
   * Accepts what waits, but so many at most that the server's other work goes on.
   *
   * @throws IOException when the system gives no more connections, as it does when the process has
   *     too many open files
   */
  public void acceptWaiting() throws IOException {
    for (ServerSocketChannel channel : channels) {
      acceptWaiting(channel);
    }
    for (ProxyGate.Arrival a; gate != null && (a = gate.next()) != null; ) {
      hand(a.channel(), a.client());
    }
  }

  /**
   * Returns where the client of the connection that is handed over now is, by a proxy's word, or
   * null if it comes by itself.
   */
  public InetSocketAddress client() {
    return client;
  }

  private void hand(SocketChannel accepted, InetSocketAddress from) throws IOException {
    client = from;
    try {
      take.invoke(server, accepted);
    } catch (ReflectiveOperationException e) {
      accepted.close();
      throw new IllegalStateException("KryoNet didn't take a connection", e);
    } finally {
      client = null;
    }
  }

  private void acceptWaiting(ServerSocketChannel channel) throws IOException {
    for (int i = 0; i < MOST_PER_TURN; i++) {
      SocketChannel accepted = channel.accept();
      if (accepted == null) {
        return;
      }
      if (gate != null && proxies.from().test(accepted.socket().getInetAddress())) {
        gate.add(accepted);
      } else {
        hand(accepted, null);
      }
    }
  }

  /** Lets the server's {@code update} return at once, now or when it is called next. Any thread. */
  public void wake() {
    selector.wakeup();
  }

  /** Closes the port. The system turns away what waits. */
  public void close() throws IOException {
    if (gate != null) {
      gate.close();
    }
    closeChannels();
  }

  private void closeChannels() throws IOException {
    for (ServerSocketChannel channel : channels) {
      channel.close();
    }
    selector.selectNow(); // the system closes a port only when no selector knows it
  }
}
