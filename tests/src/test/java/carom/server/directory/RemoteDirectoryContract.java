package carom.server.directory;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;

/**
 * Goal: a directory in another process bears a network that fails. Method: a relay between that
 * cuts connections, swallows bytes, and opens again.
 */
abstract class RemoteDirectoryContract extends DirectoryContract {
  private static final int PATIENCE_MS = 12_000;
  private static final int SLACK_MS = 10_000;

  /** Returns the port of the program that runs. */
  abstract int port();

  /** Opens a directory whose program is behind ports of this machine, at least one. */
  abstract Directory open(List<Integer> ports, int deadlineMs) throws Exception;

  /** Opens one that waits longer than a busy machine takes. */
  final Directory open(List<Integer> ports) throws Exception {
    return open(ports, PATIENCE_MS);
  }

  @Override
  final Directory open() throws Exception {
    return open(List.of(port()));
  }

  @Override
  final void pass(int ms) throws Exception {
    Thread.sleep(ms);
  }

  private static void fails(Callable<?> call) {
    long begin = System.nanoTime();
    DirectoryException e = assertThrows(DirectoryException.class, call::call);
    long ms = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - begin);
    assertTrue(ms < Directory.DEADLINE_MS + SLACK_MS, "ms=" + ms);
    assertTrue(e.getMessage().startsWith("directory="), e.getMessage());
  }

  @Test
  void aCallThatGetsNoAnswerFailsInTime() throws Exception {
    Directory other = door();
    try (CutRelay relay = new CutRelay(port());
        Directory way = open(List.of(relay.port()), Directory.DEADLINE_MS)) {
      long number = other.create(key("a"), "1", 0);
      relay.stopUp();
      fails(() -> way.get(key("a")));
      fails(() -> way.update(key("a"), "2", number));
      fails(() -> way.create(key("b"), "2", 0));
      fails(() -> way.lease(1_000));
      fails(() -> way.list(root()));
      relay.cut();
      fails(() -> way.get(key("a")));
      fails(() -> way.delete(key("a"), number));
      fails(() -> way.renew(7));
      relay.open();
      await("it answers again", () -> answers(() -> way.get(key("a"))));
      await("it lists", () -> answers(() -> assertEquals(1, way.list(root()).size())));
      assertNull(other.get(key("b")));
      await("it updates", () -> answers(() -> assertTrue(way.update(key("a"), "3", number))));
    }
  }

  private interface Step {
    void run() throws Exception;
  }

  private static boolean answers(Step step) throws Exception {
    try {
      step.run();
      return true;
    } catch (DirectoryException e) {
      return false; // the machine may be busy
    }
  }

  @Test
  void aCallGoesRoundABrokenConnection() throws Exception {
    try (CutRelay relay = new CutRelay(port());
        Directory way = open(List.of(relay.port()))) {
      for (int i = 0; i < 10; i++) {
        String key = key("k" + i);
        long number = way.create(key, "1", 0);
        assertTrue(number > 0);
        relay.breakAll();
        assertEquals(0, way.create(key, "1", 0));
        relay.breakAll();
        assertTrue(way.update(key, "2", number));
        relay.breakAll();
        assertTrue(way.renew(way.lease(60_000)));
      }
    }
  }

  @Test
  void aWatchThatBrokeTellsWhatChanged() throws Exception {
    Directory other = door();
    try (CutRelay relay = new CutRelay(port());
        Directory way = open(List.of(relay.port()), Directory.DEADLINE_MS)) {
      Heard heard = new Heard();
      long a = other.create(key("a"), "1", 0);
      long b = other.create(key("b"), "1", 0);
      long c = other.create(key("c"), "1", 0);
      way.watch(root(), heard);
      await("complete", () -> heard.completes() > 0);
      int before = heard.completes();
      relay.cut();
      other.delete(key("a"), a);
      other.update(key("b"), "2", b);
      other.delete(key("c"), c);
      other.create(key("c"), "3", 0);
      other.create(key("d"), "4", 0);
      pass(300);
      assertEquals(3, heard.values().size(), "nothing is told meanwhile");
      relay.open();
      await("complete again", () -> heard.completes() > before);
      assertEquals(Map.of(key("b"), "2", key("c"), "3", key("d"), "4"), heard.values());
      relay.breakAll();
      other.create(key("e"), "5", 0);
      await("and goes on", () -> heard.values().size() == 4);
      relay.stopUp();
      other.create(key("f"), "6", 0);
      pass(300);
      relay.open();
      await("and goes on", () -> heard.values().size() == 5);
      heard.check();
    }
  }

  @Test
  void aWatchLeavesADeadConnection() throws Exception {
    Directory other = door();
    try (CutRelay dead = new CutRelay(port());
        CutRelay alive = new CutRelay(port());
        Directory way = open(List.of(dead.port(), alive.port()), Directory.DEADLINE_MS)) {
      Heard heard = new Heard();
      way.watch(root(), heard);
      await("complete", () -> heard.completes() > 0);
      dead.stopUp();
      other.create(key("a"), "1", 0);
      await("heard by another way", () -> heard.values().size() == 1);
    }
  }

  @Test
  void callsThatOverlapAndFailHaveAnOrder() throws Exception {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println(getClass().getSimpleName() + " failing order seed=" + seed);
    History history = new History();
    AtomicBoolean isOver = new AtomicBoolean();
    try (CutRelay one = new CutRelay(port());
        CutRelay two = new CutRelay(port());
        Directory broken = open(List.of(one.port(), two.port()));
        Directory whole = open()) {
      Thread cutter =
          new Thread(
              () -> {
                Random random = new Random(~seed);
                while (!isOver.get()) {
                  try {
                    Thread.sleep(random.nextInt(12));
                  } catch (InterruptedException e) {
                    return;
                  }
                  (random.nextBoolean() ? one : two).breakAll();
                }
              });
      cutter.start();
      inThreads(
          4,
          thread -> calls(thread < 3 ? broken : whole, new Random(seed + thread), history, true));
      isOver.set(true);
      cutter.join();
      history.check("seed=" + seed + " failures=" + history.failures());
    }
  }
}
