package carom.lab.attack;

import carom.net.kryo.KryoClientTransport;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;

/**
 * Players who join and send genuine datagrams many times faster than they may, and try to come back
 * when they are kicked, again and again. A thread for each.
 */
final class PlayerFlood implements Flood {
  private static final long MS = 1_000_000L;
  private static final int BYTES = 60;
  private static final long TRY_AGAIN_NS = 100 * MS;

  private final ServerProcess server;
  private final int players;
  private final int budgets;
  private final List<Thread> threads = new ArrayList<>();
  private final AtomicLong sent = new AtomicLong();
  private final List<Long> kickedAfterMs = new ArrayList<>(); // guarded by this, as is the next
  private final TreeMap<String, Integer> endings = new TreeMap<>();
  private volatile boolean stops;

  /**
   * Creates players who haven't joined.
   *
   * @param budgets how many times the budget each of them sends
   */
  PlayerFlood(ServerProcess server, int players, int budgets) {
    this.server = server;
    this.players = players;
    this.budgets = budgets;
  }

  @Override
  public String name() {
    return players + " players, " + budgets + " times the budget each";
  }

  @Override
  public void begin() {
    stops = false;
    for (int i = 0; i < players; i++) {
      int number = i;
      Thread thread = new Thread(() -> play(number), "flooding-player-" + i);
      thread.setDaemon(true);
      thread.start();
      threads.add(thread);
    }
  }

  @Override
  public void end() throws InterruptedException {
    stops = true;
    for (Thread thread : threads) {
      thread.join();
    }
    threads.clear();
  }

  @Override
  public long sent() {
    return sent.get();
  }

  @Override
  public synchronized String findings() {
    StringBuilder text = new StringBuilder();
    if (!kickedAfterMs.isEmpty()) {
      kickedAfterMs.sort(null);
      text.append(
          String.format(
              Locale.ROOT,
              "%d times a flooding player was kicked, after %d to %d ms%n",
              kickedAfterMs.size(),
              kickedAfterMs.get(0),
              kickedAfterMs.get(kickedAfterMs.size() - 1)));
    }
    endings.forEach(
        (end, count) -> text.append(String.format(Locale.ROOT, "  %d x %s%n", count, end)));
    return text.toString();
  }

  private void play(int number) {
    try (KryoClientTransport transport = new KryoClientTransport()) {
      while (!stops) {
        Link link = transport.connect("127.0.0.1", server.tcp(), server.udp());
        Welcomes welcomes = new Welcomes();
        boolean greeted = false;
        while (!stops && !welcomes.came && link.state() != Link.State.CLOSED) {
          if (!greeted && link.state() == Link.State.OPEN) {
            greeted = true;
            link.send(
                new ClientMessage.Hello(
                    Protocol.VERSION, Protocol.physicsDigest(), "Fay" + number, 0, "", "", "", ""));
          }
          link.poll(welcomes, 100);
          LockSupport.parkNanos(MS);
        }
        flood(link, welcomes);
        note(link);
        LockSupport.parkNanos(TRY_AGAIN_NS);
      }
    }
  }

  private void flood(Link link, Welcomes welcomes) {
    byte[] bytes = new byte[BYTES];
    new Random(20).nextBytes(bytes);
    long began = System.nanoTime();
    double perNs = budgets * ProtocolLimits.MAX_INPUT_DATAGRAMS_PER_SECOND * 1e-9;
    long mine = 0;
    while (!stops && link.state() == Link.State.OPEN) {
      long due = (long) ((System.nanoTime() - began) * perNs);
      for (; mine < due && link.state() == Link.State.OPEN; mine++) {
        link.sendDatagram(bytes, 0, BYTES);
      }
      link.poll(welcomes, 100);
      LockSupport.parkNanos(MS);
    }
    sent.addAndGet(mine);
    if (mine > 0 && !stops) {
      synchronized (this) {
        kickedAfterMs.add((System.nanoTime() - began) / MS);
      }
    }
  }

  private synchronized void note(Link link) {
    if (link.state() == Link.State.CLOSED) {
      endings.merge(String.valueOf(link.closeReason()), 1, Integer::sum);
    }
  }

  /** Hears whether the server has a seat. */
  private static final class Welcomes implements LinkHandler {
    private boolean came;

    @Override
    public void message(Link from, Object message) {
      came |= message instanceof ServerMessage.Welcome;
    }

    @Override
    public void datagram(Link from, byte[] bytes, int length) {
      // it only sends
    }

    @Override
    public void closed(Link from, String reason) {
      // the loops see it
    }
  }
}
