package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.InputSource;
import carom.client.PredictionMode;
import carom.client.replay.ReplayClient;
import carom.client.view.ClientView;
import carom.fixtures.CrouchGame;
import carom.fixtures.CrouchGame.Rule;
import carom.net.transport.Impairment;
import carom.server.CaromMain;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Input;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: entities that become other archetypes are predicted where {@code input} lets them, told
 * where the rules do, and nobody sees a wrong one for long. Method: real server and clients in
 * virtual time at 150 ms and 2 % loss, the clients' own counts.
 */
class BecomeScenarioTest {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 0).withLoss(2).withSeed(Stepper.SEED);

  /** A client may show what was true this long ago, seconds. */
  private static final double LATE = 0.4;

  private static Stepper start(Rule rule) {
    return Stepper.of(CrouchGame.level(rule), ServerConfig.defaults());
  }

  private static SimulatedClient add(Stepper stepper, String name, long seed, InputSource script) {
    ClientConfig config = ClientConfig.of(name).with(ClientConfig.PREDICTION, PredictionMode.ALL);
    SimulatedClient client = stepper.add(config, FAR.withSeed(seed), script);
    stepper.awaitPlaying(client);
    return client;
  }

  @Test
  void whoCrouchesAloneIsPredictedWithoutDelay() throws Exception {
    // Goal: the own picture crouches in the tick of the key, and nothing is ever corrected.
    try (Stepper stepper = start(Rule.NOTHING)) {
      boolean[] crouches = {false};
      InputSource script =
          (view, tick, out) -> {
            crouches[0] = tick / 25 % 2 == 0;
            out.hold(Input.ACTION, crouches[0]).move(tick / 40 % 3 - 1, 0);
          };
      SimulatedClient ann = add(stepper, "Ann", 1, script);
      stepper.run(2);
      final long corrections = ann.stats().corrections();
      final long compared = ann.stats().compared();
      int changes = 0;
      String last = "";
      for (int i = 0; i < 60 * 12; i++) {
        stepper.run(1 / 60.0);
        String drawn = ann.view().own().archetype().name();
        assertEquals(crouches[0] ? "crouched" : "standing", drawn, stepper.describe());
        changes += drawn.equals(last) ? 0 : 1;
        last = drawn;
      }
      assertTrue(changes > 20, "changes=" + changes);
      assertEquals(corrections, ann.stats().corrections(), stepper.describe());
      assertTrue(ann.stats().compared() - compared > 150, stepper.describe());
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), stepper.describe());
    }
  }

  @Test
  void whatTwoPlayersAndTheRulesChangeIsPredictedOrTold(@TempDir Path folder) throws Exception {
    Path file;
    try (Stepper stepper = start(Rule.CRATES_CHANGE)) {
      file = stepper.server().record(folder).get(0);
      SimulatedClient ann = add(stepper, "Ann", 1, Scripts.wander(1));
      SimulatedClient ben = add(stepper, "Ben", 2, Scripts.wander(2));
      stepper.run(3);
      requireRight(stepper, ann, ben, "crates change");
      SimulatedClient late = add(stepper, "Late", 3, InputSource.IDLE);
      stepper.run(1);
      Seen seen = new Seen();
      for (int i = 0; i < 300; i++) {
        stepper.run(1 / 60.0);
        seen.check(stepper, ann, ben, late);
      }
      assertTrue(seen.kinds.size() >= 6, seen.kinds::toString);
    }
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int status =
        CaromMain.run(new PrintWriter(out), new PrintWriter(err), "replay", file.toString());
    assertEquals(0, status, err::toString);
    assertTrue(out.toString().contains("OK: "), out::toString);
  }

  @Test
  void aFilmThatJumpsShowsEachBodyAsItWasThen(@TempDir Path folder) throws Exception {
    // Goal: who watches a recording, or the game itself from a distance, sees what the server had
    // at
    // that tick, whether the film came there by playing or by a jump back. Method: a recording that
    // begins in the middle, when some crates are something else already; jumps to and fro.
    Map<Integer, String> had = new HashMap<>();
    Path file;
    try (Stepper stepper = start(Rule.CRATES_CHANGE)) {
      add(stepper, "Ann", 1, Scripts.wander(1));
      stepper.run(4);
      file = stepper.server().record(folder.resolve("middle.carom")).get(0);
      for (int i = 0; i < 60 * 8; i++) {
        stepper.run(1 / 60.0);
        SimulationHost s = stepper.room().simulation();
        had.put(s.tick(), kinds(s));
      }
    }
    assertTrue(had.values().stream().distinct().count() > 20, "changes");
    Random random = new Random(Stepper.SEED);
    List<Integer> ticks = had.keySet().stream().sorted().toList();
    try (ReplayClient film = new ReplayClient(file)) {
      film.pause(true);
      long nowNs = 1;
      for (int jump = 0; jump < 40; jump++) {
        int tick = ticks.get(random.nextInt(ticks.size() - 60));
        film.seek(tick);
        do {
          film.update(nowNs += 16_666_667);
        } while (film.seeking());
        assertEquals(tick, film.tick());
        assertEquals(had.get(tick), kinds(film.simulation()), "tick=" + tick);
        StringBuilder drawn = new StringBuilder();
        for (int i = 0; i < film.view().entityCount(); i++) {
          drawn.append(film.view().entity(i).archetype().name()).append(' ');
        }
        assertEquals(had.get(tick), drawn.toString(), "tick=" + tick);
        assertNull(film.divergence());
      }
    }
  }

  private static String kinds(SimulationHost s) {
    StringBuilder kinds = new StringBuilder();
    for (int id = 0; id < s.entityCapacity(); id++) {
      if (s.entity(id) != null) {
        kinds.append(s.entity(id).archetype().name()).append(' ');
      }
    }
    return kinds.toString();
  }

  @Test
  void anotherGravityForAllBeginsInTheMiddleOfAMatch() throws Exception {
    try (Stepper stepper = start(Rule.GRAVITY_CHANGES)) {
      SimulatedClient ann = add(stepper, "Ann", 1, Scripts.wander(1));
      SimulatedClient ben = add(stepper, "Ben", 2, Scripts.wander(2));
      stepper.run(3);
      requireRight(stepper, ann, ben, "gravity changes");
    }
  }

  /** Requires that nearly all that both predict in 20 seconds is right, or told. */
  private static void requireRight(
      Stepper stepper, SimulatedClient ann, SimulatedClient ben, String what) {
    SimulatedClient[] clients = {ann, ben};
    long[] before = new long[6];
    for (int i = 0; i < 2; i++) {
      before[3 * i] = clients[i].stats().awakeBodies();
      before[3 * i + 1] = clients[i].stats().exactBodies();
      before[3 * i + 2] = clients[i].stats().toldBodies();
    }
    final long full = stepper.count(Counter.NEAR_DISAGREEMENTS);
    Seen seen = new Seen();
    for (int i = 0; i < 60 * 20; i++) {
      stepper.run(1 / 60.0);
      seen.check(stepper, ann, ben);
    }
    for (int i = 0; i < 2; i++) {
      long awake = clients[i].stats().awakeBodies() - before[3 * i];
      long wrong = awake - (clients[i].stats().exactBodies() - before[3 * i + 1]);
      long told = clients[i].stats().toldBodies() - before[3 * i + 2];
      double right = 100 - 100.0 * wrong / (awake + told);
      String about =
          String.format(
              Locale.ROOT,
              "%s: %s right or told=%.2f %% of %d, told=%d fullUpdates=%d late=%.2f s %s",
              what,
              i == 0 ? "Ann" : "Ben",
              right,
              awake + told,
              told,
              stepper.count(Counter.NEAR_DISAGREEMENTS) - full,
              seen.latest,
              stepper.describe());
      assertTrue(awake > 3_500, about);
      assertTrue(right >= 99, about);
      assertTrue(told > 10, about);
    }
    assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), what);
    assertEquals(0, stepper.room().simulation().findings().count(), what);
  }

  /** Compares the archetypes that clients show with what the server had a short time ago. */
  private static final class Seen {
    /** By entity and archetype: when the server had it last, seconds. */
    private final Map<String, Double> last = new HashMap<>();

    private final Map<String, Integer> kinds = new HashMap<>();
    private double now;
    private double latest;

    void check(Stepper stepper, SimulatedClient... clients) {
      now += 1 / 60.0;
      SimulationHost s = stepper.room().simulation();
      for (int id = 0; id < s.entityCapacity(); id++) {
        if (s.entity(id) != null) {
          last.put(id + s.entity(id).archetype().name(), now);
        }
      }
      for (int i = 0; now > LATE && i < clients.length; i++) {
        ClientView view = clients[i].view();
        for (int k = 0; k < view.entityCount(); k++) {
          ClientView.Drawn drawn = view.entity(k);
          if (drawn == view.own()) {
            continue; // ahead of the server
          }
          String what = drawn.archetype().name();
          Double had = last.get(drawn.id() + what);
          HostEntity e = s.entity(drawn.id());
          assertNotNull(e, drawn.id() + " " + stepper.describe());
          if (e.ownerId() == HostEntity.NO_OWNER) {
            assertNotNull(had, clients[i].name() + " shows " + what + " " + e);
            latest = Math.max(latest, now - had);
            assertTrue(now - had <= LATE, clients[i].name() + " shows " + what + " late " + e);
            kinds.merge(clients[i].name() + what, 1, Integer::sum);
          }
        }
      }
    }
  }
}
