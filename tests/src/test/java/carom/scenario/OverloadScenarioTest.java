package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.link.ConnectionPhase;
import carom.fixtures.Levels;
import carom.net.transport.Impairment;
import carom.physics.BodyType;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Goal: on a machine that is too slow, time passes more slowly for all alike, and play goes on
 * smoothly. Method: four predicting clients, 60 ms, in virtual time; the server's clock says that
 * its work takes longer and longer.
 */
class OverloadScenarioTest {
  private static final Impairment LINE = Impairment.NONE.withLatency(30, 2);
  private static final float SHOWN_WIDTH = 64;
  private static final float SHOWN_HEIGHT = 36;

  /** What happened in some seconds. */
  private record Window(double ticksPerSecond, double missing, double corrections) {}

  private static Window window(Stepper stepper, List<SimulatedClient> clients, double seconds) {
    long ticks = stepper.room().age();
    long due = stepper.room().counters().get(Counter.INPUTS_DUE);
    long missing = stepper.room().counters().get(Counter.INPUTS_MISSING);
    long corrections = clients.stream().mapToLong(c -> c.stats().corrections()).sum();
    stepper.run(seconds);
    return new Window(
        (stepper.room().age() - ticks) / seconds,
        (double) (stepper.room().counters().get(Counter.INPUTS_MISSING) - missing)
            / (stepper.room().counters().get(Counter.INPUTS_DUE) - due),
        (clients.stream().mapToLong(c -> c.stats().corrections()).sum() - corrections) / seconds);
  }

  @Test
  void timeSlowsDownForAllAndTheClientsFollow() {
    try (Stepper stepper = Stepper.of(Levels.emptyArena(), ServerConfig.defaults())) {
      List<SimulatedClient> clients = new ArrayList<>();
      for (int i = 0; i < 4; i++) {
        clients.add(stepper.join("p" + i, LINE.withSeed(Stepper.SEED + i), Scripts.wander(i)));
      }
      stepper.run(5);
      Window before = window(stepper, clients, 10);
      assertEquals(60, before.ticksPerSecond, 1);

      stepper.serverTakes(1_500_000);
      stepper.run(5);
      long pace = stepper.room().counters().get(Counter.PACE_PERCENT);
      assertTrue(pace < 90, "pace=" + pace);
      Window slow = window(stepper, clients, 10);
      assertEquals(
          stepper.room().counters().get(Counter.PACE_PERCENT) * 0.6, slow.ticksPerSecond, 4);
      assertTrue(slow.missing <= before.missing + 0.005, before + " " + slow);
      assertTrue(slow.corrections <= before.corrections + 0.5, before + " " + slow);

      stepper.serverTakes(0);
      stepper.run(12);
      Window after = window(stepper, clients, 10);
      assertEquals(60, after.ticksPerSecond, 1);
      assertTrue(after.missing <= before.missing + 0.005, before + " " + after);
      assertTrue(after.corrections <= before.corrections + 0.5, before + " " + after);
    }
  }

  /** Goal: what a player sees is there all the time; what is elsewhere goes first, and returns. */
  @Test
  void aBusyRoomTellsPlayersOnlyOfWhatTheyShow() throws LevelException {
    Level level = Level.builtIn("commons"); // 400 by 240 m
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      List<SimulatedClient> clients = new ArrayList<>();
      for (int i = 0; i < 4; i++) {
        clients.add(stepper.join("p" + i, LINE.withSeed(Stepper.SEED + i), Scripts.wander(i)));
      }
      SimulatedClient shows = clients.get(0);
      shows.game().look(0, 0, SHOWN_WIDTH, SHOWN_HEIGHT);
      stepper.run(5);
      assertEquals(stepper.frame().count(), shows.view().entityCount(), "few bodies: all are told");
      assertFalse(shows.stats().viewsNarrow());

      stepper.serverTakes(1_500_000);
      stepper.runUntil("narrow", () -> shows.stats().viewsNarrow(), 3);
      assertEquals(100, stepper.count(Counter.PACE_PERCENT), "time slows down later");
      for (int i = 0; i < 3_000; i++) {
        if (i % 300 == 0) {
          shake(stepper.room().simulation(), i / 300 % 2 == 0 ? 3 : -3);
        }
        stepper.step();
        requireShown(stepper, shows);
      }
      int left = shows.view().entityCount();
      assertTrue(left < stepper.frame().count() / 4, "left=" + left);
      assertTrue(stepper.count(Counter.TICKS_NARROW) > 0);

      stepper.serverTakes(0);
      stepper.runUntil("wide", () -> !shows.stats().viewsNarrow(), 30);
      stepper.run(5);
      assertEquals(stepper.frame().count(), shows.view().entityCount(), "all are back");
    }
  }

  /** Lets all bodies that move at all but those of players move to one side, m/s. */
  private static void shake(SimulationHost simulation, float speed) {
    for (int id = 0; id < simulation.entityCapacity(); id++) {
      HostEntity entity = simulation.entity(id);
      if (entity != null && entity.body().type() == BodyType.DYNAMIC && entity.ownerId() < 0) {
        entity.body().setVelocity(speed, 0);
      }
    }
  }

  /** Requires that the client knows all bodies that its picture shows. */
  private static void requireShown(Stepper stepper, SimulatedClient client) {
    HostEntity own = stepper.body(client);
    SimulationHost simulation = stepper.room().simulation();
    for (int id = 0; id < simulation.entityCapacity(); id++) {
      HostEntity other = simulation.entity(id);
      if (other != null
          && Math.abs(other.body().x() - own.body().x()) < SHOWN_WIDTH / 2
          && Math.abs(other.body().y() - own.body().y()) < SHOWN_HEIGHT / 2) {
        assertTrue(client.view().find(id) != null, "id=" + id);
      }
    }
  }

  @Test
  void aRoomThatHasNoTimeLetsNobodyElseInAndSaysWhy() {
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.MAX_LOAD, 0.8);
    try (Stepper stepper = Stepper.of(Levels.emptyArena(), config)) {
      SimulatedClient first = stepper.join("first", LINE, Scripts.wander(1));
      stepper.serverTakes(1_500_000);
      stepper.run(15);
      SimulatedClient late = stepper.add("late", LINE, Scripts.wander(2));
      stepper.run(2);
      String text = String.valueOf(late.view().message());
      assertTrue(text.contains("too busy"), text);
      first.cut();
      stepper.run(3);
      assertEquals(ConnectionPhase.PLAYING, first.view().phase(), "who plays comes back");
    }
  }
}
