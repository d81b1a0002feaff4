package carom.server.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/**
 * Goal: rooms move from busy servers to idle ones, and soon come to rest. Method: the rule alone:
 * single cases, and fleets drawn at random whose servers all decide at once, seed printed.
 */
final class BalanceTest {
  private static final long S = 1_000_000_000L;

  private static ServerRecord server(long lease, double load) {
    int told = (int) Math.min(100, load) / 5 * 5;
    return new ServerRecord(
        lease,
        lease,
        "s" + lease,
        "s" + lease + ":1",
        "",
        "",
        "s" + lease + ":2",
        told,
        "",
        0,
        List.of(),
        false);
  }

  /** Asks each second, and returns the second in which a room moves; -1 for never in a minute. */
  private static int secondOfMove(Map<String, Double> rooms, ServerRecord... others) {
    Balance balance = new Balance();
    for (int second = 0; second < 60; second++) {
      if (balance.next(rooms, List.of(others), second * S) != null) {
        return second;
      }
    }
    return -1;
  }

  @Test
  void aBusyServerGivesTheRoomThatMakesTheDifferenceSmallest() {
    Map<String, Double> rooms = Map.of("a", 5.0, "b", 25.0, "c", 40.0);
    Balance balance = new Balance();
    assertNull(balance.next(rooms, List.of(server(2, 30), server(3, 10)), 0));
    Balance.Move move = balance.next(rooms, List.of(server(2, 30), server(3, 10)), 10 * S);
    assertNotNull(move);
    assertEquals("b", move.room(), "70 and 10 become 45 and 35");
    assertEquals(3, move.to().lease());
    assertNull(balance.next(rooms, List.of(server(3, 10)), 29 * S), "it rests");
  }

  @Test
  void nothingMovesWithoutNeed() {
    assertEquals(-1, secondOfMove(Map.of("a", 49.0), server(2, 0)), "half of it is idle");
    assertEquals(-1, secondOfMove(Map.of("a", 30.0, "b", 30.0), server(2, 45)), "near enough");
    assertEquals(-1, secondOfMove(Map.of("a", 90.0), server(2, 0)), "one room can't be shared");
    assertEquals(-1, secondOfMove(Map.of("a", 88.0, "b", 2.0), server(2, 0)), "too small a gain");
    assertEquals(-1, secondOfMove(Map.of("a", 30.0, "b", 30.0)), "a fleet of one");
    assertEquals(10, secondOfMove(Map.of("a", 30.0, "b", 30.0), server(2, 0)));
    Map<String, Double> tooMuch = Map.of("a", 300.0, "b", 200.0, "c", 100.0);
    assertEquals(10, secondOfMove(tooMuch, server(2, 0)));
    assertEquals(-1, secondOfMove(tooMuch, server(2, 100)), "the other one can't, either");
  }

  @Test
  void aDifferenceThatDoesNotLastMovesNothing() {
    Balance balance = new Balance();
    Map<String, Double> rooms = Map.of("a", 30.0, "b", 30.0);
    for (int second = 0; second < 100; second++) {
      double other = second % 9 == 8 ? 50 : 0;
      assertNull(balance.next(rooms, List.of(server(2, other)), second * S), "second=" + second);
    }
  }

  @Test
  void fleetsComeToRest() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("BalanceTest seed=" + seed);
    for (int fleet = 0; fleet < 300; fleet++) {
      requireRest(new Random(seed + fleet), "seed=" + (seed + fleet));
    }
  }

  private static void requireRest(Random random, String about) {
    int servers = 2 + random.nextInt(5);
    List<Map<String, Double>> owned = new ArrayList<>();
    List<Balance> rules = new ArrayList<>();
    for (int i = 0; i < servers; i++) {
      Map<String, Double> rooms = new TreeMap<>();
      int count = random.nextInt(20);
      for (int k = 0; k < count; k++) {
        rooms.put(i + "-" + k, 30 * random.nextDouble() * random.nextDouble());
      }
      owned.add(rooms);
      rules.add(new Balance());
    }
    Map<String, Integer> moves = new HashMap<>();
    int quiet = 0;
    for (int second = 0; quiet < 60; second++, quiet++) {
      assertTrue(second < 3_000, about);
      List<ServerRecord> told = new ArrayList<>();
      for (int i = 0; i < servers; i++) {
        told.add(server(i, load(owned.get(i))));
      }
      List<Balance.Move> now = new ArrayList<>(); // all decide by what was told before
      for (int i = 0; i < servers; i++) {
        List<ServerRecord> others = new ArrayList<>(told);
        others.remove(i);
        now.add(rules.get(i).next(owned.get(i), others, second * S));
      }
      for (int i = 0; i < servers; i++) {
        Balance.Move move = now.get(i);
        if (move != null) {
          double load = owned.get(i).remove(move.room());
          owned.get((int) move.to().lease()).put(move.room(), load);
          int times = moves.merge(move.room(), 1, Integer::sum);
          assertTrue(times <= 5, () -> about + " room=" + move.room() + " moved " + times);
          quiet = 0;
        }
      }
    }
    for (int i = 0; i < servers; i++) {
      double own = load(owned.get(i));
      for (int k = 0; k < servers; k++) {
        double difference = Math.min(100, own) - Math.min(100, (int) load(owned.get(k)) / 5 * 5);
        boolean helps =
            owned.get(i).values().stream()
                .map(r -> r * Math.min(100, own) / own)
                .anyMatch(r -> difference - Math.abs(difference - 2 * r) >= Balance.LEAST_GAIN);
        assertTrue(
            own < Balance.BUSY_PERCENT || difference < Balance.LEAST_DIFFERENCE || !helps, about);
      }
    }
  }

  private static double load(Map<String, Double> rooms) {
    return rooms.values().stream().mapToDouble(load -> load).sum();
  }
}
