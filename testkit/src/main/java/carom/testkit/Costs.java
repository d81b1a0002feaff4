package carom.testkit;

import carom.client.stats.NetStats;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.phase.RuleWatch;
import java.lang.StackWalker.StackFrame;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Finds out why clients shifted their players' own bodies while bots play a game. Each time, the
 * cause is looked for in the ticks since the snapshot before: a line of the game's rules that
 * changed the player's bodies or fields, also once only; an input that came too late; inputs of
 * players near it that were told after they counted; a line that changed bodies near it; else what
 * came near. One simulated world's; one thread.
 */
final class Costs implements RuleWatch {
  /** A cause of shifts of own bodies, and how often it was one. */
  record Cost(String cause, long times) {}

  private static final String LATE = "own inputs that came too late";
  private static final String INPUTS = "inputs of other players, told after they counted";
  private static final String OTHERS = "others' bodies";

  /** Ticks after which word of what the rules did has come. */
  private static final int MOST_TICKS = 300;

  private static final String ALONE = "what was not told in time";

  /** Holds what is known of one player. */
  private static final class Watched {
    /** By tick: the first line of the rules that changed what is the player's. */
    final TreeMap<Integer, String> lines = new TreeMap<>();

    int lateTick = -1;
    int comparedTick;
    long shifts;
    long missing;
    long otherInputs;
    long rulings;
  }

  private final Stepper world;
  private final GameCode code;
  private final StackWalker stack = StackWalker.getInstance();
  private final Map<Integer, Watched> players = new HashMap<>();

  /** By tick: the first line of the rules that changed an entity. */
  private final TreeMap<Integer, String> elsewhere = new TreeMap<>();

  private final Map<String, Long> times = new TreeMap<>();
  private SimulationHost watched;

  /**
   * Begins to watch a world.
   *
   * @param code tells which lines are the game's
   */
  Costs(Stepper world, GameCode code) {
    this.world = world;
    this.code = code;
  }

  /** Looks at what has happened since the last call; to be called after each step of the world. */
  void look() {
    if (world.room().simulation() != watched) { // the first match, or the next
      watched = world.room().simulation();
      watched.watchRules(this);
      players.clear();
      elsewhere.clear();
    }
    for (SimulatedClient client : world.clients()) {
      HostPlayer player = world.player(client);
      if (player != null && client.game().decoder() != null) {
        look(client, player.id());
      }
    }
  }

  private void look(SimulatedClient client, int playerId) {
    boolean isNew = !players.containsKey(playerId);
    Watched of = of(playerId);
    long missing = world.room().session(playerId).inputs().missing();
    of.lateTick = missing > of.missing ? watched.tick() : of.lateTick;
    of.missing = missing;
    int tick = client.game().decoder().newestTick();
    long shifts = client.stats().shifts();
    if (shifts > of.shifts && !isNew) {
      times.merge(cause(of, tick, client.stats()), shifts - of.shifts, Long::sum);
    }
    of.shifts = shifts;
    of.otherInputs = client.stats().otherInputs();
    of.rulings = client.stats().rulings();
    of.comparedTick = Math.max(of.comparedTick, tick);
    of.lines.headMap(of.comparedTick - 1).clear();
  }

  private String cause(Watched of, int tick, NetStats now) {
    // what was done after a step shows in the tick after it
    Map<Integer, String> since = of.lines.subMap(of.comparedTick - 1, true, tick, true);
    if (!since.isEmpty()) {
      return since.values().iterator().next();
    }
    if (of.lateTick >= of.comparedTick && of.lateTick <= tick) {
      return LATE;
    }
    if (now.otherInputs() > of.otherInputs) {
      return INPUTS;
    }
    var line = elsewhere.floorEntry(tick);
    if (now.rulings() > of.rulings && line != null) {
      return OTHERS + " by " + line.getValue();
    }
    return now.nearBodies() > 1 ? OTHERS : ALONE;
  }

  private Watched of(int playerId) {
    return players.computeIfAbsent(playerId, id -> new Watched());
  }

  @Override
  public void changes(int playerId, boolean isEntity) {
    if (playerId >= 0) {
      of(playerId).lines.computeIfAbsent(watched.tick(), tick -> line());
    }
    if (isEntity) {
      elsewhere.headMap(watched.tick() - MOST_TICKS).clear();
      elsewhere.computeIfAbsent(watched.tick(), tick -> line());
    }
  }

  /** Returns the line of the game that runs, and the callback in which it does. */
  private String line() {
    List<StackFrame> ours =
        stack.walk(
            frames ->
                frames
                    .takeWhile(f -> !f.getClassName().equals(GameWatch.class.getName()))
                    .filter(f -> code.isOfGame(f.getClassName()))
                    .toList());
    if (ours.isEmpty()) {
      return "the rules";
    }
    String callback = ours.get(ours.size() - 1).getMethodName();
    String method = ours.get(0).getMethodName();
    String in = method.equals(callback) ? "" : ", in " + callback;
    return code.line(ours.get(0).toStackTraceElement()) + in;
  }

  /** Forgets what was counted, but not what was seen. */
  void begin() {
    times.clear();
  }

  /** Returns the causes since {@link #begin}, the most frequent first. */
  List<Cost> costs() {
    List<Cost> costs = new ArrayList<>();
    times.forEach((cause, count) -> costs.add(new Cost(cause, count)));
    costs.sort(Comparator.comparingLong(Cost::times).reversed());
    return costs;
  }
}
