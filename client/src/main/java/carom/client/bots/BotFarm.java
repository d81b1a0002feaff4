package carom.client.bots;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.link.ConnectionPhase;
import carom.client.stats.NetStats;
import carom.net.transport.ClientTransport;
import carom.physics.threads.Workers;
import carom.sim.SimRandom;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Many clients that play: call {@link #update} once per frame, from one thread. Bots join one after
 * the other, since a server's queue of new connections is short; whoever finds the server busy,
 * full or out of reach tries again. Those on their way in are looked after first and several times
 * per frame: a frame of a crowd that a machine is too slow for takes a tenth of a second, and the
 * way in takes many looks.
 */
public final class BotFarm implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(BotFarm.class);

  /** Time between two joins. */
  private static final long JOIN_GAP_NS = 25_000_000L;

  /** Joins that a slow frame may make good at once. */
  private static final int MAX_JOINS_PER_FRAME = 16;

  /** So many who play are looked after between two looks at those who join. */
  private static final int SLICE = 64;

  private static final double NS_PER_S = 1e9;

  /** A bot tries to join so often, and waits in between: longer each time. */
  private static final int MAX_ATTEMPTS = 6;

  private static final long FIRST_WAIT_NS = 500_000_000L;

  private static final class Player {
    final int number;
    GameClient client;

    /** What the clients before this one measured. */
    final StaySums before = new StaySums();

    /** Of this stay: how often it tried to get in, and whether it did. */
    int attempts = 1;

    boolean entered;
    int retries;
    boolean joined;
    boolean playing;
    boolean broken;
    boolean waiting;
    long nextAttemptNs;
    int disconnects;
    int errors;
    long updatedNs;
    double inputs;
    double lateInputs;
    long leavesNs;

    final SimRandom random;

    Player(int number, long seed) {
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
  private final List<Player> players = new ArrayList<>();

  /** Of this frame: those who are on their way in, and those who play. */
  private final List<Player> joining = new ArrayList<>();

  private final List<Player> inGame = new ArrayList<>();
  private int sliceBegin;
  private long frameNs;
  private final Workers.Task lookAtJoining = (i, worker) -> update(joining.get(i), frameNs);
  private final Workers.Task lookAtSlice =
      (i, worker) -> update(inGame.get(sliceBegin + i), frameNs);
  private int started;
  private long nextJoinNs;

  /**
   * Creates bots that join from the first {@link #update} on.
   *
   * @param config of all; bot n is called by the config's name and its number
   * @param transport opens the links; stays the caller's
   * @param count how many, at least 1
   * @param seed of what they do
   * @param roam whether they walk about instead of playing
   * @param staySeconds how long each plays on average until it leaves and joins again; 0 = to the
   *     end
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
      Player p = new Player(i, seed * 7_919 + i);
      p.client = newClient(p);
      players.add(p);
    }
  }

  private GameClient newClient(Player p) {
    String name = config.name() + p.number;
    Bot bot = new Bot(seed * 1_000_003 + p.number, roam);
    return new GameClient(config.withName(name), transport, bot);
  }

  /** Lets a bot begin anew, and keeps what it has measured. */
  private void replaceClient(Player p, long nowNs) {
    p.before.add(p.client.stats(), nowNs);
    p.client.close();
    p.client = newClient(p);
  }

  /** Updates all bots, and lets the next one join when it is time. */
  public void update(long nowNs) {
    int begin = started;
    while (started < players.size() && (started == 0 || nowNs - nextJoinNs >= 0)) {
      nextJoinNs = (started == 0 ? nowNs : nextJoinNs) + JOIN_GAP_NS;
      started++;
      if (started - begin == MAX_JOINS_PER_FRAME) {
        nextJoinNs = nowNs + JOIN_GAP_NS;
      }
    }
    frameNs = nowNs;
    joining.clear();
    inGame.clear();
    for (int i = 0; i < started; i++) {
      Player p = players.get(i);
      (p.playing ? inGame : joining).add(p);
    }
    sliceBegin = 0;
    do {
      workers.run(joining.size(), lookAtJoining);
      workers.run(Math.min(SLICE, inGame.size() - sliceBegin), lookAtSlice);
      sliceBegin += SLICE;
    } while (sliceBegin < inGame.size());
  }

  private void update(Player p, long nowNs) {
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
    boolean playing = !p.broken && p.client.view().phase() == ConnectionPhase.PLAYING;
    if (p.playing && !playing) {
      p.disconnects++;
      LOG.warn("a bot stopped playing: {}", p.client.view().message());
    }
    if (playing && staySeconds > 0) {
      playing = !comesAndGoes(p, nowNs);
    }
    countInputs(p, playing, nowNs);
    p.playing = playing;
    p.entered |= playing;
    p.joined |= playing;
    if (!p.broken && !p.entered && p.attempts < MAX_ATTEMPTS && p.client.isRetryUseful()) {
      p.waiting = true;
      // Apart from each other, and from the next ones that join.
      p.nextAttemptNs = nowNs + (FIRST_WAIT_NS << p.attempts) + p.number * JOIN_GAP_NS / 4;
      LOG.info("{}{} tries again: {}", config.name(), p.number, p.client.view().message());
    }
  }

  /** Has a bot leave when it has played long enough, and join again; whether it left. */
  private boolean comesAndGoes(Player p, long nowNs) {
    if (!p.playing) {
      double seconds = 2 * staySeconds * p.random.nextFloat();
      p.leavesNs = nowNs + (long) (seconds * NS_PER_S);
      return false;
    }
    if (nowNs - p.leavesNs < 0) {
      return false;
    }
    replaceClient(p, nowNs);
    p.attempts = 1;
    p.entered = false;
    return true;
  }

  /** Of the inputs since the last look, all but the newest were made later than their tick. */
  private static void countInputs(Player p, boolean playing, long nowNs) {
    if (p.playing && playing) {
      double ticks = (nowNs - p.updatedNs) / NS_PER_S * p.client.view().tickRate();
      p.inputs += ticks;
      p.lateInputs += Math.max(0, ticks - 1);
    }
    p.updatedNs = nowNs;
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

  /** Snapshots seen by the bot that has seen the fewest. */
  public long fewestSnapshots() {
    long fewest = Long.MAX_VALUE;
    for (Player p : players) {
      fewest = Math.min(fewest, p.before.snapshots + p.client.stats().snapshots());
    }
    return fewest;
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
    return p.broken || !p.waiting && p.client.view().phase() == ConnectionPhase.ENDED;
  }

  /**
   * Why a bot could not play, in words for people; empty when all could. Of those that won't play
   * any more, if there are any.
   */
  public String problem() {
    String problem = "";
    for (Player p : players) {
      if (isOver(p)) {
        return p.broken ? "a bot broke; see the log" : p.client.view().message();
      }
      if (!p.playing && problem.isEmpty()) {
        problem = p.client.view().message();
      }
    }
    return problem;
  }

  /** A line about the last second; cheap, unlike {@link #report}. */
  public String progress() {
    double snapshots = 0;
    double rtt = 0;
    double kbit = 0;
    int disconnects = 0;
    int errors = 0;
    double inputs = 0;
    double late = 0;
    int playing = playing();
    for (Player p : players) {
      disconnects += p.disconnects;
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
   * What the bots measured in all their stays; see {@link BotReport}. Takes about a millisecond for
   * each bot, which those who play would feel.
   */
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
    for (Player p : players) {
      disconnects += p.disconnects;
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
        inputs == 0 ? 0 : 100 * late / inputs);
  }

  /** Lets all bots leave. */
  @Override
  public void close() {
    for (Player p : players) {
      p.client.close();
    }
  }
}
