package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.EventListener;
import carom.client.InputSource;
import carom.client.bots.Bot;
import carom.net.snapshot.frame.EventRecord;
import carom.net.snapshot.frame.EventRing;
import carom.net.transport.Impairment;
import carom.server.metrics.Counter;
import carom.sim.outbox.Event;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Goal: on every line each event fires exactly once, none is lost, and the events of others fire in
 * the order of their ticks. Method: bots play and then rest until every event has arrived; the
 * events that each client fired, less those it retracted, are compared with the server's one by
 * one.
 */
class EventScenarioTest {
  private static final double PLAY_SECONDS = 6;
  private static final double REST_SECONDS = 3;

  /** Ticks without an event by which those before have arrived everywhere. */
  private static final int QUIET_TICKS = 60;

  /** An event that was predicted may be up to a fifth of a second away from the server's. */
  private static final int TOLERANCE = 12;

  /** What one client hears. */
  private static final class Ear implements EventListener {
    private final SimulatedClient client;
    private final Map<String, List<Integer>> ticks = new TreeMap<>();
    private int lastTick;
    private int predicted;
    private int retracted;
    private int heard;

    Ear(SimulatedClient client) {
      this.client = client;
      client.game().events(this);
    }

    @Override
    public void happened(Event e, boolean isPredicted) {
      heard++;
      predicted += isPredicted ? 1 : 0;
      ticks.computeIfAbsent(signature(e), s -> new ArrayList<>()).add(e.tick());
      int me = client.view().playerId();
      boolean own = e.player() == me || isOwnBody(e.first()) || isOwnBody(e.second());
      if (!own && client.stats().reconnects() == 0) {
        assertTrue(e.tick() >= lastTick, client + " hears " + e + " after tick " + lastTick);
        lastTick = e.tick();
      }
    }

    private boolean isOwnBody(int key) {
      return key >= 0
          && client.game().decoder().history(key & 0xffff) != null
          && client.game().decoder().history(key & 0xffff).ownership(0) == client.view().playerId();
    }

    @Override
    public void retracted(Event e) {
      retracted++;
      assertTrue(ticks.get(signature(e)).remove((Integer) e.tick()), "it was heard before: " + e);
    }

    private static String signature(Event e) {
      return signature(e.kind().index(), e.player(), e.first(), e.second());
    }

    private static String signature(int kind, int player, int a, int b) {
      return kind + " by " + player + " of " + Math.min(a, b) + " and " + Math.max(a, b);
    }
  }

  @ParameterizedTest
  @EnumSource(ConditionTableTest.Line.class)
  void inTheArenaEveryEventFiresOnce(ConditionTableTest.Line line) {
    play("arena", line);
  }

  @ParameterizedTest
  @EnumSource(
      value = ConditionTableTest.Line.class,
      names = {"LOSS_10", "BURSTS_30", "LATENCY_100_JITTER_30", "REORDER", "LINE_64_KBIT"})
  void inThePlatformerEveryEventFiresOnce(ConditionTableTest.Line line) {
    play("platformer", line);
  }

  private static void play(String game, ConditionTableTest.Line line) {
    try (Stepper stepper = Stepper.of(game)) {
      List<Ear> ears = new ArrayList<>();
      for (int i = 0; i < 3; i++) {
        SimulatedClient client = stepper.join("p" + i, Impairment.NONE, InputSource.IDLE);
        client.impair(
            line.up.withSeed(Stepper.SEED + i), line.down.withSeed(Stepper.SEED + 100 + i));
        ears.add(new Ear(client));
      }
      stepper.run(1);
      EventRing ring = stepper.room().frames().events();
      long from = ring.limit();
      for (Ear ear : ears) {
        ear.ticks.clear();
        ear.client.play(new Bot(ear.client.view().playerId()));
      }
      if (line.blackoutSeconds() > 0) {
        stepper.run(2);
        stepper.blackout(ears.get(0).client, line.blackoutSeconds());
      }
      stepper.run(PLAY_SECONDS);
      for (Ear ear : ears) {
        ear.client.play(InputSource.IDLE);
      }
      rest(stepper, ring, ears);
      Map<String, List<Integer>> truth = told(ring, from);
      assertTrue(ring.limit() - from > 20, "events=" + (ring.limit() - from));
      assertEquals(0, stepper.count(Counter.EVENTS_LOST));
      int predicted = 0;
      for (Ear ear : ears) {
        String about = line + " " + ear.client + " heard=" + ear.heard;
        assertEquals(0, ear.client.stats().reconnects(), about);
        assertEquals(0, ear.client.stats().eventsMissed(), about);
        requireSame(truth, ear.ticks, about);
        predicted += ear.predicted - ear.retracted;
      }
      assertTrue(predicted > 0, "somebody's own deeds were predicted");
    }
  }

  /**
   * Lets everybody rest. A client is ahead of the server, and may hear what the server hasn't
   * played yet; so the end must be quiet.
   */
  private static void rest(Stepper stepper, EventRing ring, List<Ear> ears) {
    stepper.run(REST_SECONDS);
    for (int i = 0; newest(ring, ears) > stepper.room().tick() - QUIET_TICKS; i++) {
      assertTrue(i < 40, "something happens without end");
      stepper.run(0.25);
    }
  }

  private static int newest(EventRing ring, List<Ear> ears) {
    int newest = ring.limit() == 0 ? 0 : ring.at(ring.limit() - 1).tick;
    for (Ear ear : ears) {
      for (List<Integer> ticks : ear.ticks.values()) {
        newest = Math.max(newest, ticks.stream().mapToInt(tick -> tick).max().orElse(0));
      }
    }
    return newest;
  }

  /** The ticks of what the server told from an event on, by what it was. */
  private static Map<String, List<Integer>> told(EventRing ring, long from) {
    Map<String, List<Integer>> truth = new TreeMap<>();
    for (long n = from; n < ring.limit(); n++) {
      EventRecord e = ring.at(n);
      truth
          .computeIfAbsent(
              Ear.signature(e.kind, e.player, e.first, e.second), s -> new ArrayList<>())
          .add(e.tick);
    }
    return truth;
  }

  private static void requireSame(
      Map<String, List<Integer>> truth, Map<String, List<Integer>> heard, String about) {
    heard.values().removeIf(List::isEmpty);
    assertEquals(truth.keySet(), heard.keySet(), about);
    for (Map.Entry<String, List<Integer>> entry : truth.entrySet()) {
      List<Integer> expected = entry.getValue();
      List<Integer> actual = heard.get(entry.getKey());
      actual.sort(null);
      String here = about + " " + entry.getKey() + " server=" + expected + " client=" + actual;
      assertEquals(expected.size(), actual.size(), here);
      for (int i = 0; i < expected.size(); i++) {
        assertTrue(Math.abs(expected.get(i) - actual.get(i)) <= TOLERANCE, here);
      }
    }
  }

  @Test
  void whatHappensWhileTheLineIsDownIsToldOnReturn() {
    // Goal: once each, nothing lost. Method: three bots play; one's line breaks in the middle, so
    // that events that were told wait for their acks, and comes back.
    try (Stepper stepper = Stepper.of("arena")) {
      List<Ear> ears = new ArrayList<>();
      for (int i = 0; i < 3; i++) {
        Impairment line = Impairment.NONE.withLatency(50, 0).withLoss(i == 0 ? 5 : 0);
        ears.add(new Ear(stepper.join("p" + i, line.withSeed(Stepper.SEED), InputSource.IDLE)));
      }
      stepper.run(1);
      EventRing ring = stepper.room().frames().events();
      final long from = ring.limit();
      for (Ear ear : ears) {
        ear.ticks.clear();
        ear.client.play(new Bot(ear.client.view().playerId()));
      }
      stepper.run(3);
      final long before = ring.limit();
      ears.get(0).client.cut();
      ears.get(0).client.freeze(true);
      stepper.run(2);
      ears.get(0).client.freeze(false);
      stepper.run(0.2);
      stepper.awaitPlaying(ears.get(0).client);
      final long after = ring.limit();
      stepper.run(2);
      for (Ear ear : ears) {
        ear.client.play(InputSource.IDLE);
      }
      rest(stepper, ring, ears);
      Map<String, List<Integer>> truth = told(ring, from);
      assertTrue(after > before, "something happens meanwhile: " + before + " " + after);
      assertEquals(1, ears.get(0).client.stats().reconnects());
      requireSame(truth, ears.get(0).ticks, "back: " + ears.get(0).client);
    }
  }

  @Test
  void ownDeedsOfAPlayerAloneArePredictedAndConfirmed() {
    // Goal: nothing is heard late or taken back where prediction is exact. Method: a bot alone.
    try (Stepper stepper = Stepper.of("platformer")) {
      SimulatedClient client =
          stepper.join(
              "p", Impairment.NONE.withLatency(75, 0).withSeed(Stepper.SEED), InputSource.IDLE);
      Ear ear = new Ear(client);
      stepper.run(1);
      client.play(new Bot(0));
      stepper.run(20);
      int jumps = 0;
      for (Map.Entry<String, List<Integer>> e : ear.ticks.entrySet()) {
        jumps += e.getKey().startsWith("0 ") ? e.getValue().size() : 0;
      }
      assertTrue(jumps > 5, "jumps=" + jumps);
      assertEquals(jumps, ear.predicted);
      assertEquals(0, ear.retracted);
    }
  }
}
