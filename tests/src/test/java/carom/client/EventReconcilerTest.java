package carom.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.arena.ArenaGame;
import carom.sim.Role;
import carom.sim.SimState;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.event.EventKind;
import carom.sim.level.Level;
import carom.sim.outbox.Event;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: an event fires once, however often it is computed and received. Method: a real simulation
 * is stepped, taken back and stepped again by hand; the server's part is played by the test.
 */
class EventReconcilerTest {
  private static final int ME = 3;
  private static final int TOLERANCE = 12;

  private final List<String> heard = new ArrayList<>();
  private final EventListener ear =
      new EventListener() {
        @Override
        public void happened(Event e, boolean predicted) {
          heard.add((predicted ? "predicted " : "received ") + e.tick());
        }

        @Override
        public void retracted(Event e) {
          heard.add("retracted " + e.tick());
        }
      };
  private final EventReconciler reconciler = new EventReconciler(ME, true, key -> 0, 60, ear);
  private final TreeMap<Integer, SimState> states = new TreeMap<>();
  private SimulationHost s;
  private HostPlayer me;
  private EventKind kind;

  @BeforeEach
  void setUp() throws Exception {
    s = new SimulationHost(new ArenaGame(), Level.builtIn("arena"), 1, 60, Role.PREDICTION);
    me = s.mirror().join(ME, "me");
    kind = s.eventKinds().get(0);
    s.addJournal(reconciler);
    states.put(0, s.save(null));
  }

  /** Computes one tick, in which I do the thing or don't. */
  private void step(boolean happens) {
    if (happens) {
      s.emit(kind).by(me);
    }
    s.step();
    states.put(s.tick(), s.save(null));
  }

  private void step(int ticks) {
    for (int i = 0; i < ticks; i++) {
      step(false);
    }
  }

  private void back(int tick) {
    s.restore(states.get(tick));
  }

  private void tell(int player, int tick) {
    reconciler.receive(new Event().set(kind, tick, player, Event.NONE, Event.NONE, 0, 0, 0, 0));
  }

  @Test
  void whatIsPredictedFiresAtOnceAndNeverAgain() {
    step(5);
    step(true);
    assertEquals(List.of("predicted 6"), heard);
    for (int i = 0; i < 3; i++) {
      back(4);
      step(1);
      step(true);
      step(3);
    }
    tell(ME, 6);
    reconciler.complete(6);
    back(4);
    step(1);
    step(true);
    reconciler.complete(400);
    assertEquals(List.of("predicted 6"), heard);
  }

  @Test
  void whatNeverComesIsRetractedOnce() {
    step(true);
    back(0);
    step(20); // it doesn't happen after all
    reconciler.complete(TOLERANCE);
    assertEquals(List.of("predicted 1"), heard, "it may still come");
    reconciler.complete(TOLERANCE + 1);
    reconciler.complete(TOLERANCE + 2);
    reconciler.close();
    assertEquals(List.of("predicted 1", "retracted 1"), heard);
  }

  @Test
  void anotherTickIsTheSameThing() {
    step(10);
    step(true);
    back(9);
    step(3);
    step(true); // now two ticks later
    tell(ME, 15); // the server has it another two later
    reconciler.complete(100);
    assertEquals(List.of("predicted 11"), heard);
  }

  @Test
  void whatComesLaterEachTimeIsAnotherThingInTheEnd() {
    step(10);
    step(true);
    back(9);
    step(9);
    step(true); // eight ticks later
    tell(ME, 27); // the server has it another eight later: too far from what was heard
    assertEquals(List.of("predicted 11", "received 27"), heard);
    reconciler.complete(100);
    assertEquals(List.of("predicted 11", "received 27", "retracted 11"), heard);
  }

  @Test
  void whatTheServerToldFirstIsNotPredictedAfterwards() {
    step(10);
    tell(ME, 8);
    back(6);
    step(1);
    step(true);
    step(5);
    reconciler.complete(60);
    assertEquals(List.of("received 8"), heard);
  }

  @Test
  void nothingIsPredictedForTicksThatAreToldCompletely() {
    step(10);
    reconciler.complete(9);
    back(6);
    step(1);
    step(true);
    assertEquals(List.of(), heard);
  }

  @Test
  void theSameThingTwiceInShortTimeIsTwoThings() {
    step(true);
    step(2);
    step(true);
    back(0);
    step(true);
    step(2);
    step(true);
    tell(ME, 1);
    tell(ME, 4);
    reconciler.complete(100);
    assertEquals(List.of("predicted 1", "predicted 4"), heard);
  }

  @Test
  void othersAreHeardWhenThePictureShowsThem() {
    tell(7, 10);
    tell(7, 12);
    tell(ME, 11); // the own body is drawn in the present
    reconciler.advance(9.5);
    assertEquals(List.of("received 11"), heard);
    reconciler.advance(11);
    assertEquals(List.of("received 11", "received 10"), heard);
    reconciler.close();
    assertEquals(List.of("received 11", "received 10", "received 12"), heard);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void whateverIsPredictedTheSumIsTheServers(long seed) {
    // The server's things happen at random; what is predicted is right, late, missing or invented,
    // and each time a rollback computes some of it again, as wrongly.
    Random random = new Random(seed);
    TreeSet<Integer> truth = new TreeSet<>();
    for (int i = 0; i < 60; i++) {
      truth.add(1 + random.nextInt(900));
    }
    int told = 0;
    while (s.tick() < 1_000) {
      int next = s.tick() + 1;
      boolean happens = truth.contains(next - random.nextInt(2) * random.nextInt(3));
      step(random.nextInt(20) == 0 ? !happens && random.nextInt(5) == 0 : happens);
      if (random.nextInt(4) == 0 && s.tick() > told + 10) {
        int upTo = Math.min(s.tick() - 5, told + 1 + random.nextInt(20));
        for (int tick : truth.subSet(told, false, upTo, true)) {
          tell(ME, tick);
        }
        reconciler.complete(upTo);
        told = upTo;
        back(Math.max(0, told - random.nextInt(8)));
      }
    }
    for (int tick : truth.tailSet(told, false)) {
      tell(ME, tick);
    }
    reconciler.complete(2_000);
    long fired = heard.stream().filter(line -> !line.startsWith("retracted")).count();
    long retracted = heard.size() - fired;
    assertEquals(truth.size(), fired - retracted, "seed=" + seed + " " + heard);
    assertTrue(reconciler.confirmed() > 10, "confirmed=" + reconciler.confirmed());
    assertEquals(fired, reconciler.fired());
    assertEquals(retracted, reconciler.retracted());
  }
}
