package carom.net.transport;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;

/**
 * A network inside one process: links between a server side and a client side, with bounded inboxes
 * and real bytes through a {@link MessageCodec}. Only a full inbox loses data, and nothing takes
 * time; wrap links in {@link ImpairedLink} for a worse network. The two sides may run on two
 * threads, but needn't.
 */
public final class InProcessNetwork {

  /**
   * Largest number of links waiting for {@link ServerTransport#accept}. A further one is refused.
   */
  public static final int MAX_WAITING_LINKS = 1_024;

  private final MessageCodec codec;
  private final String fingerprint;
  private final Object lock = new Object();
  private final ArrayDeque<InProcessLink> waiting = new ArrayDeque<>();
  private final List<InProcessLink> links = new ArrayList<>();
  private boolean serverClosed;
  private int connections;

  private final ServerTransport server =
      new ServerTransport() {
        @Override
        public Link accept() {
          synchronized (lock) {
            return waiting.poll();
          }
        }

        @Override
        public int tcpPort() {
          return 0;
        }

        @Override
        public int udpPort() {
          return 0;
        }

        @Override
        public void close() {
          synchronized (lock) {
            serverClosed = true;
            waiting.clear();
          }
          closeLinks("the server transport was closed");
        }
      };

  private final ClientTransport client =
      new ClientTransport() {
        @Override
        public Link connect(String host, int tcpPort, int udpPort) {
          return open("in-process");
        }

        @Override
        public void close() {
          closeLinks("the client transport was closed");
        }
      };

  /** Creates a network whose messages are encoded by {@code codec}. */
  public InProcessNetwork(MessageCodec codec) {
    this(codec, "");
  }

  /**
   * Creates a network as above.
   *
   * @param fingerprint of the key that clients take the server to have proven, empty for none
   */
  public InProcessNetwork(MessageCodec codec, String fingerprint) {
    this.codec = codec;
    this.fingerprint = fingerprint;
  }

  /** Returns the server side, the same object at each call. Its ports are 0. */
  public ServerTransport server() {
    return server;
  }

  /**
   * Returns the client side, which ignores host and ports. Its links are {@code OPEN} at once, or
   * {@code CLOSED} if the server side is closed or has too many waiting links. Closing the client
   * side closes all links; it may open new ones afterwards.
   */
  public ClientTransport client() {
    return client;
  }

  /** Opens a link that comes from an address, such as 192.0.2.7, as far as the server can tell. */
  public Link connectFrom(String address) {
    return open(address);
  }

  private Link open(String address) {
    synchronized (lock) {
      links.removeIf(link -> link.state() == Link.State.CLOSED);
      int number = ++connections;
      Object pair = new Object();
      String remote = address + ":" + number;
      byte[] binding = remote.getBytes(StandardCharsets.UTF_8);
      InProcessLink serverEnd = new InProcessLink(codec, remote, pair, "", binding);
      InProcessLink clientEnd =
          new InProcessLink(codec, "in-process server", pair, fingerprint, binding);
      InProcessLink.join(serverEnd, clientEnd);
      if (serverClosed) {
        clientEnd.close("the server is not running");
      } else if (waiting.size() >= MAX_WAITING_LINKS) {
        clientEnd.close("the server accepts no more connections now");
      } else {
        waiting.add(serverEnd);
        links.add(clientEnd);
        links.add(serverEnd);
      }
      return clientEnd;
    }
  }

  private void closeLinks(String reason) {
    List<InProcessLink> all;
    synchronized (lock) {
      all = new ArrayList<>(links);
      links.clear();
    }
    for (InProcessLink link : all) {
      link.close(reason);
    }
  }
}
