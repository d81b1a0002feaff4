package carom.testkit;

import carom.client.ClientConfig;
import carom.client.bots.Bot;
import carom.client.stats.NetStats;
import carom.game.Games;
import carom.options.NetworkConditions.Preset;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.Game;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import carom.sim.phase.Findings;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;

/**
 * Tests a game: alone and together, over each network, in virtual time. Bots play it by its {@link
 * carom.client.bots.BotBrain}, or try all keys. The result is a {@link GameReport}. One thread.
 */
public final class GameTest {
  /** Time after the join that isn't measured: clocks and queues settle. */
  private static final double SETTLE_SECONDS = 2;

  private final String name;
  private final Supplier<Game> games;
  private final GameCode code;
  private final Level level;
  private final long seed;
  private final double seconds;
  private final Map<String, Integer> failures = GameWatch.failures();
  private final Map<String, String> findings = new LinkedHashMap<>();
  private final List<NetworkRun> runs = new ArrayList<>();
  private final List<String> broken = new ArrayList<>();

  private GameTest(Supplier<Game> games, Level level, double seconds, long seed) {
    this.games = games;
    Game game = games.get();
    code = new GameCode(game.getClass());
    name = game.name();
    this.level = level;
    this.seconds = seconds;
    this.seed = seed;
  }

  /**
   * Tests a game.
   *
   * @param games makes a new instance for each simulation
   * @param level where it is played
   * @param networks over which networks
   * @param players how many play together, 1..64
   * @param seconds how long each network is played, virtual time, more than 0
   * @param seed of networks and bots
   */
  public static GameReport run(
      Supplier<Game> games,
      Level level,
      List<Preset> networks,
      int players,
      double seconds,
      long seed) {
    return new GameTest(games, level, seconds, seed).run(networks, players);
  }

  private GameReport run(List<Preset> networks, int players) {
    double ms = 0;
    double bytes = 0;
    Games.Loan watched = Games.lend(GameWatch.over(games, failures));
    try {
      for (Preset network : networks) {
        play(network, 1);
        if (players > 1) {
          play(network, players);
        }
      }
      repeatLast(networks.get(networks.size() - 1), players);
    } finally {
      watched.close();
    }
    CodeCheck read = new CodeCheck(code);
    broken.addAll(read.findings());
    try {
      RepeatCheck repeat =
          new RepeatCheck(games, read, level, seed, players, (int) Math.max(120, seconds * 60));
      broken.addAll(repeat.broken());
      ms = repeat.msPerTick();
      bytes = repeat.bytesPerTick();
    } catch (RuntimeException e) {
      if (failures.isEmpty()) {
        throw e;
      }
      broken.add("computing the game again wasn't possible, because it throws " + e);
    }
    return new GameReport(
        name, level.name(), seed, seconds, runs, findings, failures, broken, ms, bytes);
  }

  /** Plays the last network again; the same seed must give the same frames. */
  private void repeatLast(Preset network, int players) {
    if (runs.isEmpty()) {
      return;
    }
    NetworkRun before = runs.get(runs.size() - 1);
    int count = runs.size();
    play(network, players);
    if (runs.size() > count && runs.remove(count).hash() != before.hash()) {
      broken.add(
          "server and clients with the same seed end in another state; use Simulation.random(), no"
              + " clock, no hash order, and no static variables that change");
    }
  }

  private void play(Preset network, int players) {
    try (Stepper world = Stepper.of(level, ServerConfig.defaults().with(ServerConfig.SEED, seed))) {
      world.expectGameFailures();
      List<SimulatedClient> clients = new ArrayList<>();
      for (int i = 0; i < players; i++) {
        clients.add(
            world.add(
                ClientConfig.of("bot" + i).withServer("localhost", 0, 0),
                network.impairment().withSeed(seed + i),
                new Bot(seed + i)));
      }
      for (SimulatedClient client : clients) {
        world.awaitPlaying(client);
      }
      Costs costs = new Costs(world, code);
      run(world, costs, SETTLE_SECONDS);
      costs.begin();
      long[] from = sums(clients);
      for (double left = seconds; left > 0; left -= 1) {
        run(world, costs, Math.min(1, left));
        note(world.room().simulation().findings());
      }
      long[] to = sums(clients);
      long awake = to[1] - from[1];
      runs.add(
          new NetworkRun(
              network.toString(),
              players,
              (to[0] - from[0]) * 60 / seconds / players,
              awake == 0 ? 100 : 100.0 * (to[2] - from[2]) / awake,
              (to[3] - from[3]) * 8 / 1_000.0 / seconds / players,
              costs.costs(),
              world.count(Counter.DIVERGENCES_UNEXPLAINED),
              firstUnexplained(world, clients),
              world.hash()));
    } catch (AssertionError | RuntimeException e) {
      if (failures.isEmpty()) {
        throw e;
      }
      String text = "players couldn't play to the end over network " + network;
      if (!broken.contains(text)) {
        broken.add(text);
      }
    }
  }

  private static void run(Stepper world, Costs costs, double seconds) {
    long endNs = world.nowNs() + (long) (seconds * 1e9);
    while (world.nowNs() - endNs < 0) {
      world.step();
      costs.look();
    }
  }

  private static String firstUnexplained(Stepper world, List<SimulatedClient> clients) {
    for (SimulatedClient client : clients) {
      HostPlayer player = world.player(client);
      String found = player == null ? null : world.room().session(player.id()).firstUnexplained();
      if (found != null) {
        return client.name() + " at " + found;
      }
    }
    return "";
  }

  private void note(Findings found) {
    for (int i = 0; i < found.count(); i++) {
      String text = found.get(i);
      findings.putIfAbsent(text.replaceFirst("entity \\d+|First seen.*", ""), text);
    }
  }

  private static long[] sums(List<SimulatedClient> clients) {
    long[] sums = new long[4];
    for (SimulatedClient client : clients) {
      NetStats stats = client.stats();
      sums[0] += stats.corrections();
      sums[1] += stats.awakeBodies();
      sums[2] += stats.exactBodies();
      sums[3] += stats.bytesIn();
    }
    return sums;
  }
}
