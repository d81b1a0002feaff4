package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.Bot;
import carom.client.bots.BotBrain;
import carom.client.bots.BotBrains;
import carom.net.transport.Impairment;
import carom.options.NetworkConditions.Preset;
import carom.server.config.ServerConfig;
import carom.server.match.MatchLibrary;
import carom.server.metrics.Counter;
import carom.sim.level.Level;
import carom.testkit.Stepper;
import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Goal: what a client predicts otherwise than the server always has a reason that both know, in
 * every game. Method: levels, players, bots and networks are drawn by a seed. The first seeds once
 * found a fault each: what came late led behind a tick that was right; a contact ended before the
 * server looked; a button pressed in a lost datagram; a player who came near while datagrams were
 * lost; a beam on a body that was near, of a robot that wasn't. {@code -Dcarom.agreement.seeds=500}
 * draws more.
 */
final class BotAgreementScenarioTest {
  private static final int NEW_SEEDS = Integer.getInteger("carom.agreement.seeds", 1);

  /** A case: who plays what, on which network. */
  private record Play(
      String level, int players, boolean brains, Impairment network, double seconds, long seed) {}

  static Stream<Play> plays() {
    Impairment line = Impairment.NONE.withLatency(25, 2).withLoss(0.5);
    Impairment far = Impairment.NONE.withLatency(75, 2).withLoss(2);
    Impairment bad = Preset.BAD.impairment();
    Impairment mobile = Preset.MOBILE.impairment();
    long first = System.nanoTime() >>> 20;
    return Stream.concat(
        Stream.of(
            new Play("arena", 3, false, bad, 20, 1),
            new Play("arena", 3, false, bad, 20, 2),
            new Play("arena", 3, false, bad, 20, Stepper.SEED),
            new Play("arena", 3, false, bad, 20, Stepper.SEED + 1),
            new Play("orbit", 4, true, line, 3, 320),
            new Play("lagoon", 4, true, mobile, 32, 197),
            new Play("shooter", 4, true, line, 23, 293),
            new Play("harbour", 3, true, far, 24, 229)),
        LongStream.range(first, first + NEW_SEEDS).mapToObj(BotAgreementScenarioTest::draw));
  }

  private static Play draw(long seed) {
    Random random = new Random(seed);
    List<String> levels = MatchLibrary.builtInLevels();
    List<Impairment> networks =
        List.of(
            Impairment.NONE.withLatency(25, 2).withLoss(0.5),
            Impairment.NONE.withLatency(100 + random.nextInt(300), 5).withLoss(random.nextInt(5)),
            Preset.BAD.impairment(),
            Preset.MOBILE.impairment());
    return new Play(
        levels.get(random.nextInt(levels.size())),
        1 + random.nextInt(4),
        random.nextInt(3) > 0,
        networks.get(random.nextInt(networks.size())),
        20,
        seed);
  }

  @ParameterizedTest
  @MethodSource("plays")
  void nothingDiffersWithoutAReason(Play play) throws Exception {
    Level level = Level.builtIn(play.level);
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.SEED, play.seed);
    try (Stepper world = Stepper.of(level, config)) {
      for (int i = 0; i < play.players; i++) {
        BotBrain brain = play.brains ? BotBrains.create(level.gameName()) : null;
        Bot bot = brain == null ? new Bot(play.seed + i) : new Bot(play.seed + i, brain);
        world.add("b" + i, play.network.withSeed(play.seed + i), bot);
      }
      world.run(play.seconds);
      assertEquals(0, world.count(Counter.DIVERGENCES_UNEXPLAINED), play.toString());
      long compared = world.clients().stream().mapToLong(c -> c.stats().compared()).sum();
      double least = 16.7 * play.seconds * play.players; // a quarter of what a good line brings
      assertTrue(compared > least, () -> "compared=" + compared + " " + play);
    }
  }
}
