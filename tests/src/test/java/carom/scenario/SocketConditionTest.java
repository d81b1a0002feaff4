package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.client.link.ConnectionPhase;
import carom.fixtures.BigWorlds;
import carom.net.protocol.PackedLevel;
import carom.net.snapshot.EntityHistory;
import carom.net.transport.Impairment;
import carom.options.Flags;
import carom.options.NetworkConditions;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.level.Level;
import carom.suite.Needs;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

/**
 * Goal: the table of conditions and the way into a large world hold over real sockets, too. Method:
 * KryoNet on loopback in real time, networks impaired by the flags that users have; the oracle is
 * the server's frame of each tick that a client decodes ({@link SimulatedClient}). The test asserts
 * nothing about time except that it ends.
 */
@Needs("sockets")
@Timeout(60)
class SocketConditionTest {
  private static final int LEAST_COMPARED = 400;
  private static final int SNAPSHOTS = 60;

  /** What {@code carom-client} and {@code carom-bots} make of these flags. */
  private static Impairment flags(String text) {
    CommandLine program = new CommandLine(CommandLine.Model.CommandSpec.create());
    Flags.add(program.getCommandSpec(), NetworkConditions.ROWS);
    String[] words = text.isEmpty() ? new String[0] : text.split(" ");
    return NetworkConditions.impairment(
        Flags.read(new ServerConfig(), program.parseArgs(words), NetworkConditions.ROWS));
  }

  @ParameterizedTest
  @CsvSource({
    "'', 0",
    "--loss=10, 0",
    "--latency=20 --jitter=10 --reorder=20 --duplicate=20, 0",
    "--latency=20, 1",
    "--bandwidth=64, 0"
  })
  void whatIsDecodedIsExactlyTheServers(String network, double blackoutSeconds) {
    Impairment line = flags(network).withSeed(Stepper.SEED);
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.VIEW, 25);
    try (Stepper stepper = Stepper.overSockets(BigWorlds.churn(), config)) {
      SimulatedClient mover = stepper.join("mover", Impairment.NONE, Scripts.wander(Stepper.SEED));
      SimulatedClient client = stepper.join("player", line, Scripts.wander(Stepper.SEED + 1));
      stepper.run(0.5);
      if (blackoutSeconds > 0) {
        stepper.blackout(client, blackoutSeconds);
        stepper.run(blackoutSeconds);
      }
      long compared = client.compared();
      long snapshots = client.stats().snapshots();
      stepper.runUntil(
          "states are decoded",
          () ->
              client.compared() - compared >= LEAST_COMPARED
                  || client.stats().snapshots() - snapshots >= SNAPSHOTS,
          20);
      String about = network + " " + stepper.describe();
      assertTrue(client.compared() > compared, about);
      assertTrue(mover.compared() > LEAST_COMPARED, about);
      assertEquals(ConnectionPhase.PLAYING, client.view().phase(), about);
      assertEquals(0, client.stats().reconnects(), about);
      assertEquals(0, client.stats().malformed(), about);
      assertEquals(0, stepper.count(Counter.DATAGRAMS_REFUSED), about);
    }
  }

  @Test
  void aLateJoinerOfTenThousandBodiesPlays() {
    int bodies = 10_000;
    Level level = BigWorlds.crates(bodies, 150, 9);
    Impairment line = flags("--latency=50 --bandwidth=2000");
    try (Stepper stepper = Stepper.overSockets(level, ServerConfig.defaults())) {
      SimulatedClient first = stepper.join("first", Impairment.NONE, Scripts.hold(0, 1));
      stepper.run(1);
      SimulatedClient late = stepper.join("late", line, InputSource.IDLE);
      int packed = PackedLevel.pack(level.source()).length;
      stepper.runUntil("it moves", () -> late.compared() > 0, 20);
      int known = 0;
      for (int slot = 0; slot < bodies; slot++) {
        EntityHistory history = late.game().decoder().history(slot);
        known += history != null && history.size() > 0 ? 1 : 0;
      }
      assertEquals(bodies, known, "packed=" + packed);
      assertEquals(ConnectionPhase.PLAYING, first.view().phase());
      assertEquals(0, late.stats().malformed());
    }
  }
}
