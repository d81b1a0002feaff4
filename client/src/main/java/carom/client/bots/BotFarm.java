package carom.client.bots;

import carom.client.ClientConfig;
import carom.client.ConnectionPhase;
import carom.client.GameClient;
import carom.client.NetStats;
import carom.net.transport.ClientTransport;
import java.util.ArrayList;
import java.util.List;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Many clients that play, driven by one thread: call {@link #update} once per frame. Bots join one
 * after the other, since a server's queue of new connections is short.
 */
public final class BotFarm implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(BotFarm.class);

  /** Time between two joins. */
  private static final long JOIN_GAP_NS = 25_000_000L;

  private static final class Player {
    final GameClient client;
    boolean joined;
    boolean playing;
    boolean broken;

    Player(GameClient client) {
      this.client = client;
    }
  }

  private final List<Player> players = new ArrayList<>();
  private int started;
  private long nextJoinNs;
  private int disconnects;
  private int errors;

  /**
   * Creates bots that join from the first {@link #update} on.
   *
   * @param config of all; bot n is called by the config's name and its number
   * @param transport opens the links; stays the caller's
   * @param count how many, at least 1
   * @param seed of what they do
   */
  public BotFarm(ClientConfig config, ClientTransport transport, int count, long seed) {
    for (int i = 1; i <= count; i++) {
      players.add(
          new Player(
              new GameClient(
                  config.withName(config.name() + i), transport, new Bot(seed * 1_000_003 + i))));
    }
  }

  /** Updates all bots, and lets the next one join when it is time. */
  public void update(long nowNs) {
    while (started < players.size() && (started == 0 || nowNs >= nextJoinNs)) {
      started++;
      nextJoinNs = nowNs + JOIN_GAP_NS;
    }
    for (int i = 0; i < started; i++) {
      update(players.get(i), nowNs);
    }
  }

  private void update(Player p, long nowNs) {
    if (p.broken) {
      return;
    }
    try {
      p.client.update(nowNs);
    } catch (RuntimeException e) {
      errors++;
      p.broken = true;
      LOG.error("a bot broke and is taken out", e);
    }
    boolean playing = !p.broken && p.client.view().phase() == ConnectionPhase.PLAYING;
    if (p.playing && !playing) {
      disconnects++;
      LOG.warn("a bot stopped playing: {}", p.client.view().message());
    }
    p.playing = playing;
    p.joined |= playing;
  }

  /** Bots asked for. */
  public int count() {
    return players.size();
  }

  /** Bots that play now. */
  public int playing() {
    int n = 0;
    for (Player p : players) {
      n += p.playing ? 1 : 0;
    }
    return n;
  }

  /** Bots that got into the game at least once. */
  public int joined() {
    int n = 0;
    for (Player p : players) {
      n += p.joined ? 1 : 0;
    }
    return n;
  }

  /** Bots that have joined, or failed to for good. */
  public int settled() {
    int n = 0;
    for (Player p : players) {
      n += p.joined || isOver(p) ? 1 : 0;
    }
    return n;
  }

  /** Whether no bot plays or tries to. */
  public boolean over() {
    for (Player p : players) {
      if (!isOver(p)) {
        return false;
      }
    }
    return true;
  }

  private static boolean isOver(Player p) {
    return p.broken || p.client.view().phase() == ConnectionPhase.ENDED;
  }

  /** Why a bot could not play, in words for people; empty when all could. */
  public String problem() {
    for (Player p : players) {
      if (!p.playing) {
        return p.broken ? "a bot broke; see the log" : p.client.view().message();
      }
    }
    return "";
  }

  /** What the bots measured; see {@link BotReport}. */
  public BotReport report(long nowNs) {
    double snapshots = 0;
    double gap = 0;
    double rtt = 0;
    double kbit = 0;
    int n = 0;
    int malformed = 0;
    for (Player p : players) {
      NetStats s = p.client.stats();
      malformed += s.malformed();
      double seconds = s.playedSeconds(nowNs);
      if (p.joined && seconds > 0) {
        n++;
        snapshots += s.snapshots() / seconds;
        gap += s.gapP99Ms();
        rtt += s.rttP50Ms();
        kbit += s.playingBytesIn() * 8 / 1_000.0 / seconds;
      }
    }
    int divisor = Math.max(1, n);
    return new BotReport(
        joined(),
        disconnects,
        errors + malformed,
        snapshots / divisor,
        gap / divisor,
        rtt / divisor,
        kbit / divisor);
  }

  /** Lets all bots leave. */
  @Override
  public void close() {
    for (Player p : players) {
      p.client.close();
    }
  }
}
