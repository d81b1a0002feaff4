package carom.client.bots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Slice;
import carom.net.transport.Impairment;
import carom.physics.Body;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.testkit.Stepper;
import java.util.List;
import java.util.Locale;
import java.util.function.LongFunction;
import org.junit.jupiter.api.Test;

/**
 * Goal: skilled bots are company for people. Method: they play against each other, and against
 * those that know the rules only roughly, on a usual line in virtual time.
 */
final class BotPlayTest {
  private static final Impairment LINE =
      Impairment.NONE.withLatency(25, 2).withLoss(0.5).withSeed(Stepper.SEED);

  /** What bots of a kind did: their points, and the part of the time in corners, percent. */
  private static final class Played {
    int points;
    int looks;
    int cornered;

    double inCorners() {
      return 100.0 * cornered / looks;
    }

    void look(SimulationHost s, HostPlayer p) {
      Body<HostEntity> body = p.entity().body();
      boolean right = Math.abs(body.x()) > s.level().bounds().maxX() - 6;
      boolean up = Math.abs(body.y()) > s.level().bounds().maxY() - 5;
      looks++;
      cornered += right && up ? 1 : 0;
    }

    @Override
    public String toString() {
      return String.format(Locale.ROOT, "points=%d inCorners=%.1f %%", points, inCorners());
    }
  }

  /** Plays a game, and returns what the bots with even numbers and what the others did. */
  private static Played[] play(
      String level, int bots, double seconds, LongFunction<Bot> even, LongFunction<Bot> odd) {
    Played[] all = {new Played(), new Played()};
    try (Stepper stepper = Stepper.of(level)) {
      for (int i = 0; i < bots; i++) {
        LongFunction<Bot> kind = i % 2 == 0 ? even : odd;
        stepper.add("b" + i, LINE.withSeed(i + 1), kind.apply(Stepper.SEED + i));
        stepper.run(0.3); // so that ids are in this order
      }
      stepper.clients().forEach(c -> c.game().ready(true));
      SimulationHost s = stepper.room().simulation();
      int[] points = new int[bots];
      for (int i = 0; i < 10 * seconds; i++) {
        stepper.run(0.1);
        for (int id = 0; id < bots; id++) {
          HostPlayer p = s.player(id);
          points[id] = Math.max(points[id], p.score());
          if (p.entity() != null) {
            all[id % 2].look(s, p);
          }
        }
      }
      for (int id = 0; id < bots; id++) {
        all[id % 2].points += points[id];
      }
    }
    return all;
  }

  @Test
  void arenaBotsPlayAllOverThePitchInsteadOfInItsCorners() {
    double seconds = Slice.of(24, 40);
    Played[] simple = play("arena", 8, seconds, Bot::new, Bot::new);
    Played[] skilled = play("arena", 8, seconds, Bot::skilled, Bot::skilled);
    String about = "simple " + List.of(simple) + " skilled " + List.of(skilled);
    double before = (simple[0].inCorners() + simple[1].inCorners()) / 2;
    double now = (skilled[0].inCorners() + skilled[1].inCorners()) / 2;
    assertTrue(now < 3 && now < before / 2, about);
  }

  @Test
  void aShotLeadsSoThatTheRocketMeetsItsTarget() {
    float t = RocketBrain.flightSeconds(8, 3, -2, 6, 20);
    assertEquals(20 * t, Math.hypot(8 - 2 * t, 3 + 6 * t), 1e-3, "seconds=" + t);
    assertTrue(t > 0.3 && t < 0.6, "seconds=" + t);
  }
}
