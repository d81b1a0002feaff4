package carom.client.bots;

import carom.physics.math.SimRandom;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * A crowd of thin clients that walk about, by one of the doors for them. Its owner calls {@link
 * #update} once per frame. Connections open on threads of their own, one after the other; a bot
 * that can't come in tries again.
 */
public final class ThinFarm implements Crowd {
  private static final long SECOND = 1_000_000_000L;
  private static final long TICK_NS = SECOND / 60;

  /** Time between two joins. */
  private static final long JOIN_GAP_NS = 25_000_000L;

  private static final int MAX_ATTEMPTS = 6;
  private static final int BUTTONS = 4;

  private static final class Player {
    final String name;
    final SimRandom random;
    ThinPicture picture = new ThinPicture();
    CompletableFuture<ThinDoor> opening;
    ThinDoor door;
    ThinDoor.Goal goal;
    int attempts;
    long nextAttemptNs;
    boolean joined;
    boolean gaveUp;
    int disconnects;
    int retries;
    int redirects;
    int reconnects;

    boolean comesBack; // it has played, and another connection follows

    /** The seat that a lost connection should bring back; empty for none. */
    String lostSeat = "";

    String problem = "";
    int count;
    int buttons;
    float moveX;
    float moveY;
    float aim;
    long changesNs;
    long nextInputNs;
    long inputs;
    long lateInputs;

    Player(String name, ThinDoor.Goal goal, long seed) {
      this.name = name;
      this.goal = goal;
      random = new SimRandom(seed);
    }

    boolean plays() {
      return door != null && picture.player() >= 0 && picture.ended() == null;
    }
  }

  private final ThinDoor.Opener opener;
  private final List<Player> players = new ArrayList<>();
  private final ExecutorService joining =
      Executors.newCachedThreadPool(
          task -> {
            Thread thread = new Thread(task, "carom-thin-joins");
            thread.setDaemon(true);
            return thread;
          });
  private long nextJoinNs;
  private boolean rests;

  /**
   * Creates bots that join from the first {@link #update} on.
   *
   * @param opener of the door
   * @param name first part of their names
   * @param room name of the room; empty for any
   * @param count how many, at least 1
   * @param seed of what they do
   */
  public ThinFarm(ThinDoor.Opener opener, String name, String room, int count, long seed) {
    this.opener = opener;
    ThinDoor.Goal goal = new ThinDoor.Goal("", room, "", "");
    for (int i = 1; i <= count; i++) {
      players.add(new Player(name + i, goal, seed * 7_919 + i));
    }
  }

  @Override
  public void update(long nowNs) {
    for (Player p : players) {
      if (p.door != null) {
        play(p, nowNs);
      } else if (p.opening != null) {
        lookAtOpening(p, nowNs);
      } else if (!p.gaveUp
          && (p.joined || nowNs - nextJoinNs >= 0) // who comes back needn't wait in a row
          && nowNs - p.nextAttemptNs >= 0) {
        nextJoinNs = p.joined ? nextJoinNs : nowNs + JOIN_GAP_NS;
        p.attempts++;
        p.retries += p.attempts > 1 ? 1 : 0;
        ThinPicture picture = p.picture;
        ThinDoor.Goal goal = p.goal;
        p.opening = CompletableFuture.supplyAsync(() -> open(p.name, goal, picture), joining);
      }
    }
  }

  private ThinDoor open(String name, ThinDoor.Goal goal, ThinPicture picture) {
    try {
      return opener.open(name, goal, picture);
    } catch (IOException e) {
      throw new CompletionException(e);
    }
  }

  private static void lookAtOpening(Player p, long nowNs) {
    if (!p.opening.isDone()) {
      return;
    }
    try {
      p.door = p.opening.join();
      p.nextInputNs = nowNs;
    } catch (CompletionException e) {
      failed(p, e.getCause().getMessage(), nowNs);
    }
    p.opening = null;
  }

  private static void failed(Player p, String why, long nowNs) {
    p.problem = p.name + ": " + why;
    p.gaveUp = p.attempts >= MAX_ATTEMPTS;
    p.disconnects += p.gaveUp && p.joined ? 1 : 0;
    p.nextAttemptNs = nowNs + p.attempts * SECOND / 2;
  }

  /** Goes where the server has sent a bot, or where its seat is without that server; or ends it. */
  private static void ended(Player p, String why, long nowNs) {
    ThinPicture s = p.picture;
    ThinDoor.Goal next = s.redirect();
    p.redirects += next == null ? 0 : 1;
    p.attempts = s.player() < 0 ? p.attempts : 0;
    p.comesBack = p.joined;
    if (next == null && !s.isRefused()) {
      next = s.seat(p.goal.server());
      p.lostSeat = next == null || !p.joined ? "" : next.secret();
    }
    p.goal = next == null ? p.goal : next;
    if (next == null && p.joined) {
      p.attempts = MAX_ATTEMPTS; // it stays away
    }
    failed(p, why, nowNs);
    if (!p.gaveUp) {
      p.picture = new ThinPicture(s);
    }
  }

  private void play(Player p, long nowNs) {
    String ended = p.picture.ended();
    if (ended != null) {
      p.door.close();
      p.door = null;
      ended(p, ended, nowNs);
      return;
    }
    p.joined |= p.plays();
    if (p.comesBack && p.plays()) {
      p.comesBack = false;
      p.reconnects++;
      p.disconnects += p.lostSeat.isEmpty() || p.lostSeat.equals(p.picture.secret()) ? 0 : 1;
      p.lostSeat = "";
    }
    if (!p.joined || nowNs - p.nextInputNs < 0) {
      return;
    }
    long due = 1 + (nowNs - p.nextInputNs) / TICK_NS;
    p.nextInputNs += due * TICK_NS;
    p.inputs += due;
    p.lateInputs += due - 1;
    p.count++;
    if (rests) {
      p.door.input(p.count, p.picture.wholeTick(), 0, 0, 0, p.aim);
      return;
    }
    if (nowNs - p.changesNs >= 0) {
      choose(p, nowNs);
      p.picture.press(p.count, nowNs);
    }
    p.door.input(p.count, p.picture.wholeTick(), p.buttons, p.moveX, p.moveY, p.aim);
  }

  private static void choose(Player p, long nowNs) {
    p.changesNs = nowNs + SECOND / 3 + (long) (p.random.nextFloat() * SECOND);
    p.aim = p.random.nextFloat() * (float) (2 * Math.PI);
    p.moveX = (float) Math.cos(p.aim);
    p.moveY = (float) Math.sin(p.aim);
    p.buttons = p.random.nextInt(BUTTONS);
  }

  /** Lets the bots stand still, or walk again. */
  public void rest(boolean stands) {
    rests = stands;
  }

  /** Returns what the bots show. */
  public List<ThinPicture> pictures() {
    return players.stream().map(p -> p.picture).toList();
  }

  @Override
  public int settled() {
    return (int) players.stream().filter(p -> p.joined || p.gaveUp).count();
  }

  @Override
  public boolean over() {
    return players.stream().allMatch(p -> p.gaveUp);
  }

  @Override
  public int playing() {
    return (int) players.stream().filter(Player::plays).count();
  }

  @Override
  public String problem() {
    return players.stream().map(p -> p.problem).filter(s -> !s.isEmpty()).findFirst().orElse("");
  }

  @Override
  public String progress() {
    BotReport r = report(System.nanoTime());
    return String.format(
        Locale.ROOT,
        "%d of %d play, disconnects=%d errors=%d late=%.0f%% snapshots=%.1f/s in=%.0f kbit/s each,"
            + " key %.1f ms. %s",
        r.playing(),
        players.size(),
        r.disconnects(),
        r.errors(),
        r.lateInputPercent(),
        r.snapshotsPerSecond(),
        r.kbitPerSecond(),
        r.keyP50Ms(),
        problem());
  }

  @Override
  public BotReport report(long nowNs) {
    double snapshots = 0;
    double gap = 0;
    double rtt = 0;
    double kbit = 0;
    double kbitUp = 0;
    double longest = 0;
    double key = 0;
    int n = 0;
    for (Player p : players) {
      ThinPicture s = p.picture;
      longest = Math.max(longest, s.longestGapMs(nowNs));
      if (s.seconds() > 0) {
        n++;
        snapshots += (s.snapshots() - 1) / s.seconds();
        gap += s.gapP99Ms();
        rtt += s.pingMs();
        kbit += s.bytesIn() * 8 / 1_000.0 / s.seconds();
        kbitUp += p.door == null ? 0 : p.door.bytesOut() * 8 / 1_000.0 / s.seconds();
        key += s.keyP50Ms();
      }
    }
    int divisor = Math.max(1, n);
    double inputs = Math.max(1, players.stream().mapToLong(p -> p.inputs).sum());
    return new BotReport(
        (int) players.stream().filter(p -> p.joined).count(),
        players.stream().mapToInt(p -> p.disconnects).sum(),
        players.stream().mapToInt(p -> p.picture.errors()).sum(),
        snapshots / divisor,
        gap / divisor,
        rtt / divisor,
        kbit / divisor,
        playing(),
        (int) players.stream().filter(p -> p.gaveUp && !p.joined).count(),
        players.stream().mapToInt(p -> p.retries).sum(),
        kbitUp / divisor,
        0,
        0,
        100 * players.stream().mapToLong(p -> p.lateInputs).sum() / inputs,
        longest,
        players.stream().mapToInt(p -> p.redirects).sum(),
        0,
        key / divisor,
        players.stream().mapToInt(p -> p.reconnects).sum());
  }

  @Override
  public void close() {
    for (Player p : players) {
      if (p.door != null) {
        p.door.close();
        p.door = null;
      }
    }
    joining.shutdownNow();
  }
}
