package carom.server.fleet;

import carom.net.seal.ExchangeKey;
import java.io.EOFException;
import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Links the servers of a fleet by TCP: each opens one {@link PeerChannel} to each other one, tells
 * it its own rooms' journals, and hears from it over the one that the other has opened.
 *
 * <p>The channel is also a canary. When its end comes and the port refuses another connection, or
 * another process answers there, the process is dead, and nobody need wait for its lease. A machine
 * that is gone or a process that is frozen ends no channel and refuses nothing: for those, the
 * lease decides.
 */
final class TcpPeers implements Peers {
  private static final Logger LOG = LoggerFactory.getLogger(TcpPeers.class);
  private static final int RETRY_MS = 250;
  private static final int FRESH_RETRY_MS = 10;
  private static final long FRESH_NS = 1_000_000_000;
  private static final int AWAIT_MS = 5_000;
  private static final int AWAIT_LOOK_MS = 20;
  private static final int BACKLOG = 64;
  private static final int MOST_SERVERS = 256;

  private final ExchangeKey key;
  private final LongSupplier lease;
  private final Inbox inbox;
  private final ServerSocket port;
  private final Map<Long, Outbound> outbound = new ConcurrentHashMap<>();
  private final Set<PeerChannel> inbound = ConcurrentHashMap.newKeySet();
  private final AtomicInteger accepting = new AtomicInteger();
  private volatile boolean closed;

  /**
   * Opens the port.
   *
   * @param bind address of this machine, or null for all
   * @param number 0 for any free port
   * @param key the fleet's
   * @param lease returns this server's present lease
   * @param inbox hears what comes
   * @throws IOException if the port isn't free
   */
  TcpPeers(InetAddress bind, int number, ExchangeKey key, LongSupplier lease, Inbox inbox)
      throws IOException {
    this.key = key;
    this.lease = lease;
    this.inbox = inbox;
    try {
      port = new ServerSocket(number, BACKLOG, bind);
    } catch (IOException e) {
      throw new IOException(
          "--fleet-port="
              + number
              + " can't be opened ("
              + e.getMessage()
              + "); end the program that has it, or choose another port",
          e);
    }
    start("carom-fleet-port", this::accept);
  }

  private static void start(String name, Runnable task) {
    Thread thread = new Thread(task, name);
    thread.setDaemon(true);
    thread.start();
  }

  /** Returns the port's number. */
  int port() {
    return port.getLocalPort();
  }

  private void accept() {
    while (!closed) {
      try {
        Socket socket = port.accept();
        if (accepting.incrementAndGet() > MOST_SERVERS) {
          accepting.decrementAndGet();
          socket.close();
          continue;
        }
        start("carom-fleet-from-" + socket.getPort(), () -> hear(socket));
      } catch (IOException e) {
        if (!closed) {
          LOG.warn("fleet: the port can't accept a server: {}", e.getMessage());
          pause(RETRY_MS);
        }
      }
    }
  }

  private void hear(Socket socket) {
    long from = 0;
    try (PeerChannel channel = PeerChannel.accept(socket, key)) {
      inbound.add(channel);
      channel.write(PeerFrame.of(PeerFrame.Kind.HELLO, lease.getAsLong()).toBytes());
      PeerFrame hello = PeerFrame.parse(channel.read());
      if (hello.kind() != PeerFrame.Kind.HELLO) {
        throw new IOException("the first frame is " + hello.kind());
      }
      from = hello.number();
      while (!closed) {
        PeerFrame frame = PeerFrame.parse(channel.read());
        if (frame.kind() == PeerFrame.Kind.COMMAND || frame.kind() == PeerFrame.Kind.SAVED) {
          channel.write(inbox.answer(frame).toBytes());
        } else if (frame.kind() == PeerFrame.Kind.AWAIT) {
          channel.write(PeerFrame.of(PeerFrame.Kind.DONE, frame.number()).toBytes());
        } else {
          inbox.take(from, frame);
        }
      }
    } catch (EOFException e) {
      LOG.debug("fleet: server {} has closed its link", from);
    } catch (IOException | RuntimeException e) {
      if (!closed) {
        LOG.info("fleet: the link from {} has ended: {}", socket.getInetAddress(), e.toString());
      }
    } finally {
      accepting.decrementAndGet();
      if (from != 0 && !closed) {
        inbox.lost(from);
      }
    }
  }

  /** The channel to one server, which is opened again and again until that server is forgotten. */
  private final class Outbound implements Runnable {
    private final ServerRecord server;
    private final Map<Long, Runnable> questions = new ConcurrentHashMap<>();
    private final AtomicLong asked = new AtomicLong();
    private volatile PeerChannel channel; // null while there is none
    private volatile boolean forgotten;
    private long lostNs; // its own thread's; 0 while it was never lost

    Outbound(ServerRecord server) {
      this.server = server;
    }

    @Override
    public void run() {
      String host = server.peerHost();
      int number = server.peerPort();
      boolean wasThere = false;
      while (!forgotten && !closed) {
        try (PeerChannel opened = PeerChannel.open(host, number, key)) {
          opened.write(PeerFrame.of(PeerFrame.Kind.HELLO, lease.getAsLong()).toBytes());
          PeerFrame hello = PeerFrame.parse(opened.read());
          if (hello.number() != server.lease()) {
            if (wasThere) {
              inbox.dead(server.lease());
            }
            rest();
            continue;
          }
          wasThere = true;
          channel = opened;
          while (true) {
            heard(PeerFrame.parse(opened.read()));
          }
        } catch (ConnectException e) {
          if (wasThere && !forgotten && isRefused(e)) {
            inbox.dead(server.lease());
          }
          rest();
        } catch (IOException e) {
          if (channel != null) {
            lostNs = System.nanoTime();
          } else if (!forgotten) {
            LOG.debug("fleet: server {} isn't reached: {}", server.name(), e.toString());
            rest();
          }
        } finally {
          channel = null;
          questions.clear();
        }
      }
    }

    /**
     * Waits a moment: a short one after a loss, since a process that ends refuses a little later.
     */
    private void rest() {
      boolean isFresh = lostNs != 0 && System.nanoTime() - lostNs < FRESH_NS;
      pause(isFresh ? FRESH_RETRY_MS : RETRY_MS);
    }

    private boolean isRefused(ConnectException e) {
      return e.getMessage() != null && e.getMessage().contains("refused");
    }

    private void heard(PeerFrame frame) {
      Runnable then = questions.remove(frame.number());
      if (then != null) {
        then.run();
      }
    }

    private PeerChannel reached() throws IOException {
      PeerChannel present = channel;
      if (present == null) {
        throw new IOException("server " + server.name() + " isn't reached");
      }
      return present;
    }

    void whenDone(Runnable then) throws IOException {
      PeerChannel present = reached();
      long number = asked.incrementAndGet();
      questions.put(number, then);
      try {
        present.write(PeerFrame.of(PeerFrame.Kind.AWAIT, number).toBytes());
      } catch (IOException e) {
        questions.remove(number);
        throw e;
      }
    }

    void await() throws IOException {
      PeerChannel present = reached();
      CountDownLatch done = new CountDownLatch(1);
      whenDone(done::countDown);
      long endNs = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(AWAIT_MS);
      try {
        while (!done.await(AWAIT_LOOK_MS, TimeUnit.MILLISECONDS)) {
          if (channel != present || System.nanoTime() - endNs >= 0) {
            throw new IOException("server " + server.name() + " doesn't answer");
          }
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new IOException("interrupted", e);
      }
    }

    void forget() {
      forgotten = true;
      PeerChannel present = channel;
      if (present != null) {
        present.close();
      }
    }
  }

  private static void pause(int ms) {
    try {
      Thread.sleep(ms);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public void reach(ServerRecord server) {
    if (closed || server.peerPort() == 0) {
      return;
    }
    outbound.computeIfAbsent(
        server.lease(),
        number -> {
          Outbound link = new Outbound(server);
          start("carom-fleet-to-" + server.name(), link);
          return link;
        });
  }

  @Override
  public void forget(long server) {
    Outbound link = outbound.remove(server);
    if (link != null) {
      link.forget();
    }
  }

  @Override
  public Set<Long> reached() {
    return Set.copyOf(outbound.keySet());
  }

  @Override
  public boolean isReached(long server) {
    Outbound link = outbound.get(server);
    return link != null && link.channel != null;
  }

  private Outbound link(long server) throws IOException {
    Outbound link = outbound.get(server);
    if (link == null) {
      throw new IOException("server " + server + " of the fleet is gone");
    }
    return link;
  }

  @Override
  public void send(long server, PeerFrame frame) throws IOException {
    link(server).reached().write(frame.toBytes());
  }

  @Override
  public void whenDone(long server, Runnable then) throws IOException {
    link(server).whenDone(then);
  }

  @Override
  public void await(long server) throws IOException {
    link(server).await();
  }

  @Override
  public PeerFrame ask(ServerRecord server, PeerFrame question) throws IOException {
    return ask(server, key, question);
  }

  /**
   * Asks a server something, over a link for that alone.
   *
   * @param key the fleet's
   * @throws IOException if it can't be reached; the message says why
   */
  static PeerFrame ask(ServerRecord server, ExchangeKey key, PeerFrame question)
      throws IOException {
    try (PeerChannel channel = PeerChannel.open(server.peerHost(), server.peerPort(), key)) {
      channel.waitAtMost(AWAIT_MS);
      channel.write(PeerFrame.of(PeerFrame.Kind.HELLO, 0).toBytes());
      PeerFrame.parse(channel.read());
      channel.write(question.toBytes());
      return PeerFrame.parse(channel.read());
    }
  }

  @Override
  public void close() {
    closed = true;
    outbound.values().forEach(Outbound::forget);
    outbound.clear();
    inbound.forEach(PeerChannel::close);
    try {
      port.close();
    } catch (IOException e) {
      LOG.debug("fleet: the port can't be closed: {}", e.getMessage());
    }
  }
}
