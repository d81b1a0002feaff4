package carom.net.kryo;

import carom.net.transport.Link;
import carom.net.transport.LinkCounters;
import carom.net.transport.LinkHandler;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Function;

/**
 * A client's link to a name that may have several addresses, of which some may be dead (RFC 8305,
 * "Happy Eyeballs"). It tries them one after the other, a quarter of a second apart, without giving
 * up the earlier ones. The first that works in full, by TCP and UDP, is the link from then on, and
 * the others close. One that works by TCP alone waits a moment for a better one.
 *
 * <p>A daemon thread runs the race and ends with it.
 */
final class AddressRace implements Link {
  /** Finds the addresses of a name. */
  interface Names {
    InetAddress[] addresses(String host) throws UnknownHostException;
  }

  /** RFC 8305's "Connection Attempt Delay", ns. */
  private static final long HEAD_START_NANOS = 250_000_000L;

  /** Time that an address without UDP waits for a better one, ns. */
  private static final long COURTESY_NANOS = 1_000_000_000L;

  private static final long LOOK_NANOS = 5_000_000L;
  private static final int MAX_ADDRESSES = 8;

  private final String host;
  private final String remote;
  private final Names names;
  private final Function<InetAddress, ClientLink> open;
  private final LinkCounters noTraffic = new LinkCounters();
  private final List<ClientLink> attempts = new CopyOnWriteArrayList<>();
  private final Thread thread;
  private volatile ClientLink winner;
  private volatile String failure; // why nobody won, or null
  private volatile boolean mayPass;

  // used by the owner's thread
  private boolean reported;
  private LinkHandler served;
  private LinkHandler renamed;

  /**
   * Creates a link in {@code CONNECTING}; {@link #start} begins.
   *
   * @param names finds the addresses of the host
   * @param open starts an attempt at an address
   */
  AddressRace(String host, int tcpPort, Names names, Function<InetAddress, ClientLink> open) {
    this.names = names;
    this.host = host;
    this.remote = host + ":" + tcpPort;
    this.open = open;
    thread = new Thread(this::run, "carom-connect-" + remote);
    thread.setDaemon(true);
  }

  void start() {
    thread.start();
  }

  /** Returns addresses in the system's order, but of both kinds in turn, as RFC 8305 says. */
  static List<InetAddress> interleaved(InetAddress... addresses) {
    List<InetAddress> first = new ArrayList<>();
    List<InetAddress> second = new ArrayList<>();
    for (InetAddress address : addresses) {
      boolean isLikeFirst = address instanceof Inet4Address == addresses[0] instanceof Inet4Address;
      (isLikeFirst ? first : second).add(address);
    }
    List<InetAddress> all = new ArrayList<>();
    for (int i = 0; i < Math.max(first.size(), second.size()); i++) {
      all.addAll(first.subList(Math.min(i, first.size()), Math.min(i + 1, first.size())));
      all.addAll(second.subList(Math.min(i, second.size()), Math.min(i + 1, second.size())));
    }
    return all.subList(0, Math.min(MAX_ADDRESSES, all.size()));
  }

  private void run() {
    try {
      race(interleaved(names.addresses(host)));
    } catch (UnknownHostException x) {
      fail("unknown host " + host + ": check the address");
    } catch (RuntimeException | Error x) { // for example, no thread is left
      fail("can't connect to " + remote + ": " + x);
    } finally {
      for (ClientLink attempt : attempts) {
        if (attempt != winner) {
          attempt.close("another address of " + host + " was faster");
        }
      }
    }
  }

  private void race(List<InetAddress> addresses) {
    long startedNs = 0;
    long courtesySinceNs = 0;
    while (winner == null && failure == null) {
      long now = System.nanoTime();
      boolean allEnded = attempts.stream().allMatch(a -> a.state() == State.CLOSED);
      if (attempts.size() < addresses.size() && (allEnded || now - startedNs > HEAD_START_NANOS)) {
        attempts.add(open.apply(addresses.get(attempts.size())));
        startedNs = now;
        continue;
      }
      ClientLink overTcp = null;
      boolean othersTry = attempts.size() < addresses.size();
      for (ClientLink attempt : attempts) {
        State state = attempt.state();
        if (state == State.OPEN && !attempt.isOverTcp()) {
          win(attempt);
          return;
        }
        overTcp = state == State.OPEN && overTcp == null ? attempt : overTcp;
        othersTry |= state == State.CONNECTING;
      }
      if (overTcp != null) {
        courtesySinceNs = courtesySinceNs == 0 ? now : courtesySinceNs;
        if (!othersTry || now - courtesySinceNs > COURTESY_NANOS) {
          win(overTcp);
          return;
        }
      } else if (!othersTry) {
        explain();
        return;
      }
      LockSupport.parkNanos(LOOK_NANOS);
    }
  }

  private synchronized void win(ClientLink attempt) {
    if (failure == null) {
      winner = attempt;
    }
  }

  private synchronized boolean fail(String reason) {
    if (winner != null || failure != null) {
      return false;
    }
    failure = reason;
    return true;
  }

  /** Ends with the reason of the attempt that came furthest. */
  private void explain() {
    ClientLink best = attempts.get(0);
    for (ClientLink attempt : attempts) {
      best = attempt.isAnswered() && !best.isAnswered() ? attempt : best;
    }
    mayPass = attempts.stream().anyMatch(ClientLink::mayPass);
    fail(best.closeReason());
  }

  /** Returns whether all threads have ended. */
  boolean isOver() {
    return !thread.isAlive() && attempts.stream().allMatch(ClientLink::isOver);
  }

  /**
   * Waits until the threads have ended. Returns true if the waiting thread was interrupted
   * meanwhile.
   */
  boolean await(long deadline) {
    boolean interrupted = false;
    while (thread.isAlive() && System.nanoTime() - deadline < 0) {
      try {
        thread.join(50);
      } catch (InterruptedException x) {
        interrupted = true;
      }
    }
    for (ClientLink attempt : attempts) {
      interrupted |= attempt.await(deadline);
    }
    return interrupted;
  }

  @Override
  public State state() {
    ClientLink won = winner;
    if (won != null) {
      return won.state();
    }
    return failure == null ? State.CONNECTING : State.CLOSED;
  }

  @Override
  public boolean send(Object message) {
    ClientLink won = winner;
    return won != null && won.send(message);
  }

  @Override
  public boolean sendDatagram(byte[] bytes, int offset, int length) {
    ClientLink won = winner;
    return won != null && won.sendDatagram(bytes, offset, length);
  }

  @Override
  @SuppressWarnings("ReferenceEquality") // the same handler, not an equal one
  public int poll(LinkHandler handler, int max) {
    ClientLink won = winner;
    if (won != null) {
      if (served != handler) {
        served = handler;
        renamed = handler.as(this);
      }
      return won.poll(renamed, max);
    }
    if (failure != null && !reported) {
      reported = true;
      handler.closed(this, failure);
    }
    return 0;
  }

  @Override
  public long waitedNs() {
    return winner.waitedNs();
  }

  @Override
  public void close(String reason) {
    fail(reason);
    for (ClientLink attempt : attempts) {
      attempt.close(reason);
    }
    LockSupport.unpark(thread);
  }

  @Override
  public boolean isOverTcp() {
    ClientLink won = winner;
    return won != null && won.isOverTcp();
  }

  @Override
  public byte[] binding() {
    ClientLink won = winner;
    return won == null ? null : won.binding();
  }

  @Override
  public String serverFingerprint() {
    ClientLink won = winner;
    return won == null ? "" : won.serverFingerprint();
  }

  @Override
  public boolean mayPass() {
    return mayPass;
  }

  @Override
  public String remote() {
    return remote;
  }

  @Override
  public String closeReason() {
    ClientLink won = winner;
    String why = failure;
    return won != null ? won.closeReason() : why == null ? "" : why;
  }

  @Override
  public LinkCounters counters() {
    ClientLink won = winner;
    return won == null ? noTraffic : won.counters();
  }

  @Override
  public String toString() {
    return "AddressRace[" + remote + ", " + state() + "]";
  }
}
