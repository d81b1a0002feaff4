package carom.client.bots;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.link.ConnectionPhase;
import carom.client.stats.NetStats;
import carom.net.transport.ClientTransport;
import carom.physics.math.SimRandom;
import carom.physics.threads.Workers;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A crowd of bots. Its owner calls {@link #update} once per frame, from one thread.
 *
 * <p>Bots join one after the other, because a server's queue of new connections is short. A bot
 * that finds the server busy, full or out of reach tries again. Joining takes many updates, so
 * joining bots are updated first and several times per frame: on a slow machine a frame of a large
 * crowd takes a tenth of a second.
 */
public final class BotFarm implements Crowd {
  private static final Logger LOG = LoggerFactory.getLogger(BotFarm.class);

  /** Time between two joins. */
  private static final long JOIN_GAP_NS = 25_000_000L;

  /** Most joins in one frame, after slow ones. */
  private static final int MAX_JOINS_PER_FRAME = 16;

  /** Most time for which the others wait for the first bot. */
  private static final long MAX_AHEAD_NS = 3_000_000_000L;

  /** Playing bots that are updated between two updates of the joining ones. */
  private static final int SLICE = 64;

  private static final double NS_PER_S = 1e9;

  /** Attempts of a bot to join, with a longer wait after each one. */
  private static final int MAX_ATTEMPTS = 6;

  private static final long FIRST_WAIT_NS = 500_000_000L;

  private static final class BotPlayer {
    final int number;
    GameClient client;

    /** Figures of the bot's earlier clients. */
    final StaySums before = new StaySums();

    /** Attempts to join in this stay. */
    int attempts = 1;

    boolean entered;
    int retries;
    boolean joined;
    boolean playing;

    /** The bot plays, loads the next match of a game in which it played, or comes back to it. */
    boolean stays;

    boolean broken;
    boolean waiting;

    /** The match in which the bot has said that it is ready. */
    int readyInMatch = -1;

    long nextAttemptNs;
    int disconnects;
    int errors;
    long updatedNs;
    double inputs;
    double lateInputs;
    long leavesNs;

    /** Snapshots of the present client when it was looked at last, and when there were more. */
    long snapshots;

    long snapshotNs;
    long longestGapNs;
    int redirects;
    int reconnects;
    int ticksLost;

    final SimRandom random;

    BotPlayer(int number, long seed) {
      this.number = number;
      this.random = new SimRandom(seed);
    }
  }

  private final ClientConfig config;
  private final ClientTransport transport;
  private final long seed;
  private final boolean roam;
  private final double staySeconds;
  private final Workers workers;
  private final List<BotPlayer> players = new ArrayList<>();

  /** Bots that are joining in this frame. */
  private final List<BotPlayer> joining = new ArrayList<>();

  private final List<BotPlayer> inGame = new ArrayList<>();
  private int sliceBegin;
  private long frameNs;
  private final Workers.Task lookAtJoining = (i, worker) -> update(joining.get(i), frameNs);
  private final Workers.Task lookAtSlice =
      (i, worker) -> update(inGame.get(sliceBegin + i), frameNs);
  private int started;
  private long firstNs;
  private long nextJoinNs;

  /**
   * Creates bots that join from the first {@link #update} on.
   *
   * @param config of all bots; bot n is named by the config's name and its number
   * @param transport opens the links; stays the caller's
   * @param count how many, at least 1
   * @param seed of what they do
   * @param roam whether they walk about instead of playing
   * @param staySeconds mean time that a bot plays until it leaves and joins again; 0 = to the end
   * @param workers share the bots within a frame; stay the caller's
   */
  public BotFarm(
      ClientConfig config,
      ClientTransport transport,
      int count,
      long seed,
      boolean roam,
      double staySeconds,
      Workers workers) {
    this.config = config;
    this.staySeconds = staySeconds;
    this.workers = workers;
    this.transport = transport;
    this.seed = seed;
    this.roam = roam;
    for (int i = 1; i <= count; i++) {
      BotPlayer p = new BotPlayer(i, seed * 7_919 + i);
      p.client = newClient(p);
      players.add(p);
    }
  }

  private GameClient newClient(BotPlayer p) {
    String name = config.get(ClientConfig.NAME) + p.number;
    long ofBot = seed * 1_000_003 + p.number;
    Bot bot = roam ? new Bot(ofBot, true) : Bot.skilled(ofBot);
    return new GameClient(config.with(ClientConfig.NAME, name), transport, bot);
  }

  /** Gives a bot a new client, and keeps the figures of the old one. */
  private void replaceClient(BotPlayer p, long nowNs) {
    p.before.add(p.client.stats(), nowNs);
    p.redirects += p.client.stats().redirects();
    p.reconnects += p.client.stats().reconnects();
    p.disconnects += p.client.stats().sessionsLost();
    p.ticksLost += p.client.stats().ticksLost();
    p.snapshots = 0;
    p.client.close();
    p.client = newClient(p);
    p.readyInMatch = -1;
  }

  /** Updates all bots, and starts the next ones when it is time. */
  @Override
  public void update(long nowNs) {
    startBots(nowNs);
    frameNs = nowNs;
    joining.clear();
    inGame.clear();
    for (int i = 0; i < started; i++) {
      BotPlayer p = players.get(i);
      (p.playing ? inGame : joining).add(p);
    }
    sliceBegin = 0;
    do {
      workers.run(joining.size(), lookAtJoining);
      workers.run(Math.min(SLICE, inGame.size() - sliceBegin), lookAtSlice);
      sliceBegin += SLICE;
    } while (sliceBegin < inGame.size());
  }

  /**
   * Starts the bots whose time it is. The first goes ahead until it has seen something: in a fresh
   * JVM its join takes half a second, in which others that played would see nothing.
   */
  private void startBots(long nowNs) {
    int begin = started;
    if (started == 0) {
      firstNs = nowNs;
    }
    while (started < players.size() && (started == 0 || nowNs - nextJoinNs >= 0)) {
      if (started == 1 && isAhead(players.get(0), nowNs)) {
        nextJoinNs = nowNs;
        return;
      }
      nextJoinNs = (started == 0 ? nowNs : nextJoinNs) + JOIN_GAP_NS;
      started++;
      if (started - begin == MAX_JOINS_PER_FRAME) {
        nextJoinNs = nowNs + JOIN_GAP_NS;
      }
    }
  }

  private boolean isAhead(BotPlayer first, long nowNs) {
    return first.snapshots == 0 && !isOver(first) && nowNs - firstNs < MAX_AHEAD_NS;
  }

  private void update(BotPlayer p, long nowNs) {
    if (p.broken || p.waiting && nowNs < p.nextAttemptNs) {
      return;
    }
    if (p.waiting) {
      p.waiting = false;
      p.attempts++;
      p.retries++;
      replaceClient(p, nowNs);
    }
    try {
      p.client.update(nowNs);
    } catch (RuntimeException e) {
      p.errors++;
      p.broken = true;
      LOG.error("a bot broke and is taken out", e);
    }
    ConnectionPhase phase = p.client.view().phase();
    boolean playing = !p.broken && phase == ConnectionPhase.PLAYING;
    boolean comes = phase == ConnectionPhase.LOADING || phase == ConnectionPhase.RECONNECTING;
    boolean stays = playing || p.stays && !p.broken && comes;
    if (p.stays && !stays) {
      p.disconnects++;
      LOG.warn("a bot stopped playing: {}", p.client.view().message());
    }
    p.stays = stays;
    if (playing && staySeconds > 0) {
      playing = !comesAndGoes(p, nowNs);
    }
    if (playing && p.readyInMatch != p.client.view().matchNumber() && p.client.ready(true)) {
      p.readyInMatch = p.client.view().matchNumber();
    }
    countInputs(p, playing, nowNs);
    measureGap(p, nowNs);
    p.playing = playing;
    p.entered |= playing;
    p.joined |= playing;
    if (!p.broken && !p.entered && p.attempts < MAX_ATTEMPTS && p.client.isRetryUseful()) {
      p.waiting = true;
      // Apart from each other, and from the next ones that join.
      p.nextAttemptNs = nowNs + (FIRST_WAIT_NS << p.attempts) + p.number * JOIN_GAP_NS / 4;
      LOG.info(
          "{}{} tries again: {}",
          config.get(ClientConfig.NAME),
          p.number,
          p.client.view().message());
    }
  }

  /** Replaces the client of a bot that has played long enough; returns whether it did. */
  private boolean comesAndGoes(BotPlayer p, long nowNs) {
    if (!p.playing) {
      double seconds = 2 * staySeconds * p.random.nextFloat();
      p.leavesNs = nowNs + (long) (seconds * NS_PER_S);
      return false;
    }
    if (nowNs - p.leavesNs < 0) {
      return false;
    }
    replaceClient(p, nowNs);
    p.stays = false;
    p.attempts = 1;
    p.entered = false;
    return true;
  }

  /** Counts inputs: all but the newest since the last update were sampled too late. */
  private static void countInputs(BotPlayer p, boolean playing, long nowNs) {
    if (p.playing && playing) {
      double ticks = (nowNs - p.updatedNs) / NS_PER_S * p.client.view().tickRate();
      p.inputs += ticks;
      p.lateInputs += Math.max(0, ticks - 1);
    }
    p.updatedNs = nowNs;
  }

  /** Measures how long a bot that has joined is without a snapshot. */
  private static void measureGap(BotPlayer p, long nowNs) {
    long snapshots = p.client.stats().snapshots();
    if (p.entered && !isOver(p) && p.snapshots > 0) {
      p.longestGapNs = Math.max(p.longestGapNs, nowNs - p.snapshotNs);
    }
    if (snapshots > p.snapshots) {
      p.snapshots = snapshots;
      p.snapshotNs = nowNs;
    }
  }

  /** Returns how many bots are playing. */
  @Override
  public int playing() {
    int n = 0;
    for (BotPlayer p : players) {
      n += p.playing ? 1 : 0;
    }
    return n;
  }

  /** Returns how many bots got into the game at least once. */
  public int joined() {
    int n = 0;
    for (BotPlayer p : players) {
      n += p.joined ? 1 : 0;
    }
    return n;
  }

  /** Returns the fewest snapshots that any bot has received. */
  public long fewestSnapshots() {
    long fewest = Long.MAX_VALUE;
    for (BotPlayer p : players) {
      fewest = Math.min(fewest, p.before.snapshots + p.client.stats().snapshots());
    }
    return fewest;
  }

  /** Returns how many bots have joined or given up. */
  @Override
  public int settled() {
    int n = 0;
    for (BotPlayer p : players) {
      n += p.joined || isOver(p) ? 1 : 0;
    }
    return n;
  }

  /** Returns whether no bot plays or tries to. */
  @Override
  public boolean over() {
    for (BotPlayer p : players) {
      if (!isOver(p)) {
        return false;
      }
    }
    return true;
  }

  private static boolean isOver(BotPlayer p) {
    return p.broken || !p.waiting && p.client.view().phase() == ConnectionPhase.ENDED;
  }

  /**
   * Returns why a bot can't play, in words for people; empty if all can. Prefers a bot that has
   * given up.
   */
  @Override
  public String problem() {
    String problem = "";
    for (BotPlayer p : players) {
      if (isOver(p)) {
        return p.broken ? "a bot broke; see the log" : p.client.view().message();
      }
      if (!p.playing && problem.isEmpty()) {
        problem = p.client.view().message();
      }
    }
    return problem;
  }

  /** Returns a line about the last second; cheap, unlike {@link #report}. */
  @Override
  public String progress() {
    double snapshots = 0;
    double rtt = 0;
    double kbit = 0;
    int disconnects = 0;
    int errors = 0;
    double inputs = 0;
    double late = 0;
    int playing = playing();
    for (BotPlayer p : players) {
      disconnects += disconnects(p);
      errors += p.errors;
      inputs += p.inputs;
      late += p.lateInputs;
      if (p.playing) {
        NetStats s = p.client.stats();
        snapshots += s.snapshotsPerSecond();
        rtt += s.rttMs();
        kbit += s.kbitInPerSecond();
      }
    }
    if (playing == 0) {
      return "0 of " + players.size() + " play. " + problem();
    }
    int divisor = Math.max(1, playing);
    return String.format(
        Locale.ROOT,
        "%d of %d play, disconnects=%d errors=%d late=%.0f%% snapshots=%.1f/s rtt=%.1f ms in=%.0f"
            + " kbit/s each",
        playing,
        players.size(),
        disconnects,
        errors,
        inputs == 0 ? 0 : 100 * late / inputs,
        snapshots / divisor,
        rtt / divisor,
        kbit / divisor);
  }

  /**
   * Returns the figures of all stays of the bots; see {@link BotReport}. Takes about a millisecond
   * per bot, which disturbs bots that play.
   */
  @Override
  public BotReport report(long nowNs) {
    double snapshots = 0;
    double gap = 0;
    double rtt = 0;
    double kbit = 0;
    double kbitUp = 0;
    int n = 0;
    int retries = 0;
    int rejected = 0;
    long awake = 0;
    long right = 0;
    double corrections = 0;
    int disconnects = 0;
    int errors = 0;
    double inputs = 0;
    double late = 0;
    long longestGapNs = 0;
    int redirects = 0;
    int reconnects = 0;
    int ticksLost = 0;
    for (BotPlayer p : players) {
      longestGapNs = Math.max(longestGapNs, p.longestGapNs);
      redirects += p.redirects + p.client.stats().redirects();
      reconnects += p.reconnects + p.client.stats().reconnects();
      ticksLost += p.ticksLost + p.client.stats().ticksLost();
      disconnects += disconnects(p);
      errors += p.errors;
      inputs += p.inputs;
      late += p.lateInputs;
      StaySums s = new StaySums();
      s.add(p.before);
      s.add(p.client.stats(), nowNs);
      retries += p.retries;
      rejected += !p.entered && isOver(p) ? 1 : 0;
      awake += s.awakeBodies;
      right += s.exactBodies;
      errors += s.malformed;
      if (s.seconds > 0) {
        n++;
        snapshots += s.snapshots / s.seconds;
        gap += s.gapP99Ms();
        rtt += s.rttP50Ms();
        kbit += s.bytesIn * 8 / 1_000.0 / s.seconds;
        corrections += s.corrections * 60 / s.seconds;
        kbitUp += s.bytesOut * 8 / 1_000.0 / s.seconds;
      }
    }
    int divisor = Math.max(1, n);
    return new BotReport(
        joined(),
        disconnects,
        errors,
        snapshots / divisor,
        gap / divisor,
        rtt / divisor,
        kbit / divisor,
        playing(),
        rejected,
        retries,
        kbitUp / divisor,
        awake == 0 ? 0 : 100.0 * right / awake,
        corrections / divisor,
        inputs == 0 ? 0 : 100 * late / inputs,
        longestGapNs / 1e6,
        redirects,
        ticksLost,
        0,
        reconnects);
  }

  /** Returns how often a bot has lost its place, for good or for one in which it began anew. */
  private static int disconnects(BotPlayer p) {
    return p.disconnects + p.client.stats().sessionsLost();
  }

  /** Makes all bots leave. */
  @Override
  public void close() {
    for (BotPlayer p : players) {
      p.client.close();
    }
  }
}
