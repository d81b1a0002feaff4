package carom.server.directory;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.BrokenBarrierException;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: every directory keeps the promises of {@link Directory}. Method: two servers' ways to one
 * directory, short leases, many threads, random calls beside a model, and all orders in which calls
 * that overlapped can have taken effect.
 */
@Timeout(180)
abstract class DirectoryContract {
  private static final AtomicInteger TESTS = new AtomicInteger();
  private static final int TTL_MS = 1_000;

  private final List<Directory> doors = new ArrayList<>();

  /** The beginning of all keys of this test. */
  private final String root = "test" + TESTS.incrementAndGet() + "/";

  /** Opens another server's way to the directory. */
  abstract Directory open() throws Exception;

  /** Lets some milliseconds pass. */
  abstract void pass(int ms) throws Exception;

  final Directory door() throws Exception {
    Directory door = open();
    doors.add(door);
    return door;
  }

  final String key(String name) {
    return root + name;
  }

  final String root() {
    return root;
  }

  @AfterEach
  void closeDoors() {
    doors.forEach(Directory::close);
  }

  final void await(String what, Callable<Boolean> condition) throws Exception {
    for (int i = 0; !condition.call(); i++) {
      assertTrue(i < 1_500, what);
      pass(10);
    }
  }

  private static final Directory.Succession NONE = new Directory.Succession(0, 0);

  @Test
  void anEntryIsCreatedOnce() throws Exception {
    Directory a = door();
    Directory b = door();
    long lease = a.lease(60_000);
    assertNull(a.get(key("cup")));
    long number = a.create(key("cup"), "one", lease);
    assertTrue(number > 0);
    assertEquals(new DirectoryEntry(key("cup"), "one", number, lease), b.get(key("cup")));
    assertEquals(0, b.create(key("cup"), "two", b.lease(60_000)));
    assertEquals(0, a.create(key("cup"), "one", lease), "nor again by the same server");
    assertEquals("one", a.get(key("cup")).value());
    long stays = b.create(key("ban"), "x", 0);
    assertEquals(new DirectoryEntry(key("ban"), "x", stays, 0), a.get(key("ban")));
    assertEquals(
        List.of(key("ban"), key("cup")), a.list(root()).stream().map(DirectoryEntry::key).toList());
    assertEquals(List.of(), a.list(root() + "none"));
  }

  @Test
  void anEntrySucceedsTheOneBefore() throws Exception {
    Directory a = door();
    Directory b = door();
    String note = key("note");
    long ended = b.lease(60_000);
    b.revoke(ended);
    assertEquals(NONE, b.succeed(key("cup"), "x", ended, note));
    Directory.Succession first = a.succeed(key("cup"), "one", a.lease(60_000), note);
    assertEquals(0, first.before());
    assertEquals(first.number(), a.get(key("cup")).number());
    long lease = b.lease(60_000);
    assertEquals(NONE, b.succeed(key("cup"), "two", lease, note), "it is there");
    assertTrue(a.delete(key("cup"), first.number()));
    Directory.Succession next = b.succeed(key("cup"), "two", lease, note);
    assertTrue(next.number() > first.number());
    assertEquals(first.number(), next.before());
    assertEquals(new DirectoryEntry(key("cup"), "two", next.number(), lease), a.get(key("cup")));
    b.revoke(lease);
    Directory.Succession last = a.succeed(key("cup"), "three", 0, note);
    assertEquals(next.number(), last.before(), "the note outlives leases");
  }

  @Test
  void anOldNumberChangesNothing() throws Exception {
    Directory a = door();
    Directory b = door();
    long lease = a.lease(60_000);
    long old = a.create(key("cup"), "one", lease);
    assertTrue(a.update(key("cup"), "two", old));
    assertTrue(b.update(key("cup"), "three", old), "another server may, if it knows the number");
    assertEquals(new DirectoryEntry(key("cup"), "three", old, lease), a.get(key("cup")));
    assertFalse(a.update(key("cup"), "four", old + 1));
    assertFalse(a.delete(key("cup"), old + 1));
    assertFalse(a.delete(key("nothing"), old));
    assertFalse(a.delete(key("nothing"), 0));
    assertFalse(a.update(key("nothing"), "x", 0));
    assertTrue(a.delete(key("cup"), old));
    assertFalse(b.delete(key("cup"), old), "of several callers one is told true");
    long number = b.create(key("cup"), "five", b.lease(60_000));
    assertTrue(number > old);
    assertFalse(a.update(key("cup"), "six", old));
    assertFalse(a.delete(key("cup"), old));
    assertEquals("five", a.get(key("cup")).value());
  }

  @Test
  void aLeaseThatEndedIsOverForEver() throws Exception {
    Directory a = door();
    Directory b = door();
    long lease = a.lease(TTL_MS);
    long old = a.create(key("cup"), "one", lease);
    a.create(key("fen"), "one", lease);
    long stays = a.create(key("ban"), "x", 0);
    await("the entry must go", () -> b.get(key("cup")) == null);
    assertFalse(a.renew(lease));
    assertFalse(b.renew(lease));
    assertNull(a.get(key("fen")));
    assertEquals(1, a.list(root()).size());
    assertEquals(0, a.create(key("cup"), "two", lease), "nothing is created under it");
    assertFalse(a.update(key("cup"), "two", old));
    assertFalse(a.delete(key("cup"), old));
    long other = a.lease(TTL_MS);
    assertNotEquals(lease, other);
    assertTrue(b.create(key("cup"), "three", b.lease(60_000)) > old);
    assertTrue(a.update(key("ban"), "y", stays));
  }

  @Test
  void aRenewedLeaseStays() throws Exception {
    Directory a = door();
    long lease = a.lease(3 * TTL_MS);
    long number = a.create(key("cup"), "one", lease);
    for (int i = 0; i < 10; i++) {
      pass(400);
      assertTrue(a.renew(lease));
      assertEquals(number, a.get(key("cup")).number());
    }
    await("without, it goes", () -> a.get(key("cup")) == null);
    assertFalse(a.renew(lease));
  }

  @Test
  void anotherServerRevokes() throws Exception {
    Directory a = door();
    Directory b = door();
    long lease = a.lease(60_000);
    long kept = a.lease(60_000);
    long number = a.create(key("cup"), "one", lease);
    a.create(key("fen"), "one", kept);
    b.revoke(lease);
    assertNull(a.get(key("cup")));
    assertFalse(a.renew(lease));
    assertTrue(a.renew(kept));
    assertEquals(0, a.create(key("cup"), "one", lease));
    assertFalse(a.update(key("cup"), "one", number));
    assertEquals("one", a.get(key("fen")).value());
    b.revoke(lease);
    b.revoke(Long.MAX_VALUE - 1);
    assertFalse(a.renew(Long.MAX_VALUE - 1));
    assertEquals(0, a.create(key("cup"), "one", Long.MAX_VALUE - 1));
  }

  @Test
  void aWatcherHearsOfAll() throws Exception {
    Directory a = door();
    Directory b = door();
    long lease = a.lease(60_000);
    long first = a.create(key("rooms/a"), "1", lease);
    a.create(key("roofs/a"), "1", lease);
    Heard heard = new Heard();
    b.watch(key("rooms/"), heard);
    await("complete", () -> heard.completes() > 0);
    assertEquals(Map.of(key("rooms/a"), "1"), heard.values());
    a.update(key("rooms/a"), "2", first);
    await("update", () -> heard.values().equals(Map.of(key("rooms/a"), "2")));
    long stays = a.create(key("rooms/b"), "3", 0);
    await("creation", () -> heard.values().size() == 2);
    b.delete(key("rooms/a"), first);
    await("deletion", () -> heard.values().equals(Map.of(key("rooms/b"), "3")));
    long again = a.create(key("rooms/a"), "4", lease);
    await("again", () -> heard.values().size() == 2);
    assertEquals(
        new DirectoryEntry(key("rooms/a"), "4", again, lease), heard.entry(key("rooms/a")));
    a.revoke(lease);
    await("revoked", () -> heard.values().equals(Map.of(key("rooms/b"), "3")));
    a.create(key("rooms/c"), "5", a.lease(TTL_MS));
    await("with a short lease", () -> heard.values().size() == 2);
    await("the lease ends", () -> heard.values().size() == 1);
    a.delete(key("rooms/b"), stays);
    await("empty", () -> heard.values().isEmpty());
    b.close();
    a.create(key("rooms/d"), "6", 0);
    pass(100);
    assertEquals(Map.of(), heard.values(), "a closed directory tells nothing");
    heard.check();
  }

  @Test
  void aWatcherHearsThatAnEntryIsAnother() throws Exception {
    Directory a = door();
    Heard heard = new Heard();
    a.watch(root(), heard);
    Directory b = door();
    for (int i = 0; i < 30; i++) {
      long number = b.create(key("cup"), "same", 0);
      assertTrue(number > 0);
      if (i < 29) {
        assertTrue(b.delete(key("cup"), number));
      }
    }
    long last = b.get(key("cup")).number();
    await("the last", () -> heard.entry(key("cup")) != null && heard.number(key("cup")) == last);
    heard.check();
  }

  @Test
  void textsComeBackAsTheyWere() throws Exception {
    Directory a = door();
    Heard heard = new Heard();
    a.watch(root(), heard);
    List<String> texts =
        List.of(
            "",
            "\n",
            "a\nb\r\n",
            "\"{}[]',;--%_*?\\$1",
            "\u0001\u007f\u0080\u2028\ufeff\uffff",
            "Übung 日本 \ud83c\udfb1 \ud800\udc00\udbff\udfff",
            "x".repeat(Directory.MAX_VALUE_BYTES),
            "é".repeat(Directory.MAX_VALUE_BYTES / 2));
    Map<String, String> expected = new HashMap<>();
    for (String text : texts) {
      String end = text.isEmpty() ? "e" : text.substring(0, Math.min(200, text.length()));
      String key = key(end + (expected.containsKey(key(end)) ? "2" : ""));
      long number = a.create(key, text, 0);
      assertEquals(new DirectoryEntry(key, text, number, 0), a.get(key));
      assertTrue(a.update(key, text + (text.length() < 100 ? "!" : ""), number));
      expected.put(key, text + (text.length() < 100 ? "!" : ""));
    }
    await("watched", () -> heard.values().equals(expected));
    List<String> keys = a.list(root()).stream().map(DirectoryEntry::key).toList();
    assertEquals(expected.keySet().stream().sorted().toList(), keys);
    for (String prefix : List.of("%", "_", "\\", "\"", "é", "Ü", "\ud83c\udfb1")) {
      assertEquals(
          keys.stream().filter(key -> key.startsWith(key(prefix))).toList(),
          a.list(key(prefix)).stream().map(DirectoryEntry::key).toList());
    }
  }

  @Test
  void whatIsTooLongIsRefused() throws Exception {
    Directory a = door();
    String longest = root() + "k".repeat(Directory.MAX_KEY_CHARS - root().length());
    long number = a.create(longest, "x", 0);
    assertTrue(number > 0);
    assertEquals("x", a.get(longest).value());
    for (String bad : List.of("", longest + "k", key("\0"), key("\ud800"))) {
      refused(() -> a.create(bad, "x", 0));
      refused(() -> a.update(bad, "x", 1));
      refused(() -> a.delete(bad, 1));
      refused(() -> a.get(bad));
    }
    String many = "é".repeat(Directory.MAX_VALUE_BYTES / 2) + "x";
    for (String bad : List.of(many, "a\0", "\udc00")) {
      refused(() -> a.create(key("v"), bad, 0));
      refused(() -> a.update(longest, bad, number));
    }
    refused(() -> a.list(longest + "k"));
    refused(() -> a.lease(999));
    refused(() -> a.lease(600_001));
    assertNull(a.get(key("v")));
    assertEquals("x", a.get(longest).value());
  }

  private static void refused(Callable<?> call) {
    assertThrows(IllegalArgumentException.class, call::call);
  }

  @Test
  void aLongListIsWhole() throws Exception {
    Directory a = door();
    long lease = a.lease(600_000);
    String value = "v".repeat(1_000);
    int many = 1_100;
    inThreads(
        4,
        thread -> {
          for (int i = thread; i < many; i += 4) {
            assertTrue(a.create(key("n" + i), value + i, lease) > 0);
          }
        });
    List<DirectoryEntry> entries = a.list(root());
    assertEquals(many, entries.size());
    Heard heard = new Heard();
    a.watch(root(), heard);
    await("all", () -> heard.completes() > 0);
    assertEquals(many, heard.values().size());
    a.revoke(lease);
    await("none", () -> heard.values().isEmpty());
    assertEquals(List.of(), a.list(root()));
  }

  @Test
  void eachKeyHasOneOwner() throws Exception {
    int keys = 50;
    Map<String, List<Long>> owners = new ConcurrentHashMap<>();
    List<Directory> ways = List.of(door(), door());
    CyclicBarrier start = new CyclicBarrier(8);
    inThreads(
        8,
        thread -> {
          Directory way = ways.get(thread % 2);
          long lease = way.lease(60_000);
          for (int i = 0; i < keys; i++) {
            if (i % 10 == 0) {
              meet(start);
            }
            long number = way.create(key("k" + i), "same", lease);
            if (number > 0) {
              owners.computeIfAbsent(key("k" + i), k -> new ArrayList<>()).add(number);
              assertEquals(lease, way.get(key("k" + i)).lease());
            }
          }
        });
    assertEquals(keys, owners.size());
    owners.forEach((key, numbers) -> assertEquals(1, numbers.size(), key));
    assertEquals(keys, owners.values().stream().map(n -> n.get(0)).distinct().count());
  }

  @Test
  void oneCallerDeletes() throws Exception {
    Directory a = door();
    AtomicInteger deleted = new AtomicInteger();
    CyclicBarrier start = new CyclicBarrier(8);
    long[] number = new long[1];
    for (int i = 0; i < 20; i++) {
      number[0] = a.create(key("ticket"), "x", 0);
      inThreads(
          8,
          thread -> {
            meet(start);
            deleted.addAndGet(a.delete(key("ticket"), number[0]) ? 1 : 0);
          });
      assertEquals(i + 1, deleted.get());
    }
  }

  private static void meet(CyclicBarrier barrier) throws InterruptedException {
    try {
      barrier.await();
    } catch (BrokenBarrierException e) {
      throw new AssertionError(e);
    }
  }

  interface Work {
    void run(int thread) throws Exception;
  }

  static void inThreads(int threads, Work work) throws Exception {
    ExecutorService pool = Executors.newFixedThreadPool(threads);
    try {
      List<Future<?>> all = new ArrayList<>();
      for (int i = 0; i < threads; i++) {
        int thread = i;
        all.add(
            pool.submit(
                () -> {
                  work.run(thread);
                  return null;
                }));
      }
      for (Future<?> one : all) {
        one.get();
      }
    } finally {
      pool.shutdownNow();
    }
  }

  /** Random calls, one after the other, through several doors, beside a model. */
  @Test
  void randomCallsDoAsTheModel() throws Exception {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println(getClass().getSimpleName() + " model seed=" + seed);
    Random random = new Random(seed);
    List<Directory> ways = List.of(door(), door(), door());
    Heard heard = new Heard();
    ways.get(0).watch(root(), heard);
    Map<String, DirectoryEntry> model = new HashMap<>();
    List<Long> leases = new ArrayList<>(); // those that live
    List<Long> ended = new ArrayList<>();
    long last = 0;
    for (int i = 0; i < 600; i++) {
      Directory way = ways.get(random.nextInt(ways.size()));
      String key = key("k" + random.nextInt(6));
      DirectoryEntry entry = model.get(key);
      long number = entry != null && random.nextInt(4) > 0 ? entry.number() : last - 1;
      boolean isCurrent = entry != null && entry.number() == number;
      String step = "seed=" + seed + " call=" + i;
      switch (random.nextInt(9)) {
        case 0 -> leases.add(way.lease(600_000));
        case 1 -> {
          if (!leases.isEmpty() && random.nextInt(3) == 0) {
            long lease = leases.remove(random.nextInt(leases.size()));
            ended.add(lease);
            way.revoke(lease);
            model.values().removeIf(e -> e.lease() == lease);
          }
        }
        case 2 -> {
          for (long lease :
              Stream.concat(leases.stream().limit(2), ended.stream().limit(2)).toList()) {
            assertEquals(leases.contains(lease), way.renew(lease), step);
          }
        }
        case 3, 4, 5 -> {
          boolean old = !ended.isEmpty() && random.nextInt(5) == 0;
          List<Long> from = old ? ended : leases;
          long lease =
              from.isEmpty() || random.nextInt(4) == 0 ? 0 : from.get(random.nextInt(from.size()));
          long created = way.create(key, "v" + i, lease);
          boolean may = entry == null && (lease == 0 || leases.contains(lease));
          assertEquals(may, created > 0, step);
          if (may) {
            assertTrue(created > last, step);
            last = created;
            model.put(key, new DirectoryEntry(key, "v" + i, created, lease));
          }
        }
        case 6 -> {
          assertEquals(isCurrent, way.update(key, "u" + i, number), step);
          if (isCurrent) {
            model.put(key, new DirectoryEntry(key, "u" + i, number, entry.lease()));
          }
        }
        case 7 -> {
          assertEquals(isCurrent, way.delete(key, number), step);
          if (isCurrent) {
            model.remove(key);
          }
        }
        default -> assertEquals(entry, way.get(key), step);
      }
      if (i % 50 == 0) {
        assertEquals(
            model.keySet().stream().sorted().map(model::get).toList(), way.list(root()), step);
      }
    }
    await("seed=" + seed + ": the watcher knows all", () -> heard.entries().equals(model));
    heard.check();
  }

  /** Calls that overlap: there must be an order of them that explains all answers. */
  @Test
  void callsThatOverlapHaveAnOrder() throws Exception {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println(getClass().getSimpleName() + " order seed=" + seed);
    History history = new History();
    List<Directory> ways = List.of(door(), door());
    inThreads(4, thread -> calls(ways.get(thread % 2), new Random(seed + thread), history, false));
    history.check("seed=" + seed);
  }

  /**
   * Makes random calls to a few keys and notes them.
   *
   * @param repeats whether connections break, so that a call may be sent again
   */
  final void calls(Directory way, Random random, History history, boolean repeats) {
    Map<String, Long> known = new HashMap<>();
    for (int i = 0; i < 60; i++) {
      String key = key("k" + random.nextInt(3));
      String value = "v" + random.nextInt(1 << 30);
      long number = known.getOrDefault(key, 0L);
      switch (random.nextInt(5)) {
        case 0, 1 -> {
          long created = history.create(way, key, value);
          known.put(key, created > 0 ? created : number);
        }
        case 2 -> history.update(way, key, value, number);
        case 3 -> {
          if (!repeats || !history.isCreating(key)) {
            history.delete(way, key, number);
          }
        }
        default -> {
          DirectoryEntry entry = history.get(way, key);
          known.put(key, entry == null ? number : entry.number());
        }
      }
    }
  }
}
