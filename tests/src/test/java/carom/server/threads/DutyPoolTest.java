package carom.server.threads;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.suite.Needs;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Goal: duties that share threads can't tell it from having one each. */
@Needs("waits")
@Timeout(120)
class DutyPoolTest {
  private static final long SEED = Long.getLong("carom.seed", System.nanoTime());

  private final Watchdog watchdog = new Watchdog(Guard.class);
  private final List<DutyPool.Shift> shifts = new ArrayList<>();
  private final Queue<String> hanging = new ConcurrentLinkedQueue<>();
  private final AtomicInteger ended = new AtomicInteger();
  private volatile boolean ends;
  private DutyPool pool;

  /** Stands for the class through which all calls of games go. */
  static final class Guard {
    private Guard() {}

    static void call(Runnable game) {
      game.run();
    }
  }

  @AfterEach
  void end() throws Exception {
    ends = true;
    shifts.forEach(DutyPool.Shift::stop);
    pool.close();
    watchdog.close();
    await("all threads end", () -> threads().isEmpty());
  }

  private void pool(int size) {
    pool = new DutyPool("carom-pooled", size, Thread.NORM_PRIORITY, System::nanoTime, watchdog);
    watchdog.start();
  }

  private DutyPool.Shift add(Duty duty) {
    String title = "duty " + shifts.size();
    DutyPool.Shift shift =
        pool.add(
            title,
            duty,
            0,
            (thread, callback, stack) -> hanging.add(title + " in " + callback + " on " + thread),
            over -> ended.incrementAndGet());
    shifts.add(shift);
    return shift;
  }

  private static Set<String> threads() {
    Set<String> names = new TreeSet<>();
    for (Thread thread : Thread.getAllStackTraces().keySet()) {
      if (thread.getName().startsWith("carom-pooled")) {
        names.add(thread.getName());
      }
    }
    return names;
  }

  private static void await(String what, BooleanSupplier done) throws Exception {
    long endNs = System.nanoTime() + 60_000_000_000L;
    while (!done.getAsBoolean()) {
      assertTrue(System.nanoTime() < endNs, what + " isn't so after a minute");
      Thread.sleep(2);
    }
  }

  private void spin() {
    while (!ends) {
      Thread.onSpinWait();
    }
  }

  /** Counts without any lock: right only if turns never overlap and see what came before. */
  private static final class Counting extends TestDuty {
    private final Random random;
    private final AtomicBoolean busy = new AtomicBoolean();
    private final AtomicInteger turns = new AtomicInteger();
    private final AtomicInteger changes = new AtomicInteger();
    private long plain;
    private Thread last;
    private volatile String problem;

    Counting(long seed) {
      random = new Random(seed);
    }

    @Override
    public void turn(long nowNs) {
      if (!busy.compareAndSet(false, true)) {
        problem = "two turns overlap";
      }
      if (plain != turns.get()) {
        problem = "turn " + turns + " sees " + plain;
      }
      if (last != Thread.currentThread()) {
        last = Thread.currentThread();
        changes.incrementAndGet();
      }
      if (random.nextInt(8) == 0) {
        LockSupport.parkNanos(random.nextInt(3_000_000));
      }
      plain++;
      turns.incrementAndGet();
      busy.set(false);
    }

    @Override
    public long napNs(long nowNs) {
      return random.nextInt(4) == 0 ? Long.MAX_VALUE : random.nextInt(2_000_000) - 200_000;
    }

    @Override
    public boolean hasLinks() {
      return random.nextBoolean();
    }
  }

  @Test
  void turnsOfADutyNeverOverlapAndSeeEachOthersWrites() throws Exception {
    pool(4);
    Random random = new Random(SEED);
    List<Counting> duties = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      duties.add(new Counting(random.nextLong()));
      add(duties.get(i));
    }
    await(
        "each has had its turns",
        () -> {
          shifts.get(random.nextInt(shifts.size())).wake();
          return duties.stream().allMatch(duty -> duty.turns.get() > 300);
        });
    String told = "seed=" + SEED;
    for (Counting duty : duties) {
      assertEquals(null, duty.problem, told);
    }
    assertTrue(duties.stream().anyMatch(duty -> duty.changes.get() > 1), told + ": none moved");
    shifts.forEach(DutyPool.Shift::stop);
    shifts.forEach(shift -> shift.join(System.nanoTime() + 10_000_000_000L));
    assertEquals(40, ended.get());
  }

  /** A duty that counts, and hangs on demand. */
  private class Hanging extends TestDuty {
    private final AtomicInteger turns = new AtomicInteger();
    private volatile boolean hangs;

    @Override
    public void turn(long nowNs) {
      turns.incrementAndGet();
      if (hangs) {
        Guard.call(DutyPoolTest.this::spin);
      }
    }

    @Override
    public long napNs(long nowNs) {
      return 5_000_000;
    }
  }

  @Test
  void moreDutiesHangAtOnceThanThereAreThreadsAndTheOthersGoOn() throws Exception {
    pool(2);
    List<Hanging> duties = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      duties.add(new Hanging());
      add(duties.get(i));
    }
    await("all run", () -> duties.stream().allMatch(duty -> duty.turns.get() > 10));
    for (int i = 0; i < 5; i++) {
      duties.get(2 * i).hangs = true;
    }
    await("all that hang are found", () -> hanging.size() == 5);
    for (String line : hanging) {
      assertTrue(line.matches("duty [02468] in call of .* on carom-pooled-\\d+"), line);
    }
    int[] before = duties.stream().mapToInt(duty -> duty.turns.get()).toArray();
    await(
        "the others go on",
        () -> {
          boolean all = true;
          for (int i = 0; i < duties.size(); i++) {
            all &= duties.get(i).hangs || duties.get(i).turns.get() > before[i] + 20;
          }
          return all;
        });
    assertEquals(5 + 2, threads().size(), "two that work, and those that are abandoned");
    ends = true;
    await("those that come back end", () -> threads().size() == 2);
    for (int i = 0; i < 5; i++) {
      assertEquals(before[2 * i], duties.get(2 * i).turns.get(), "nobody runs it any more");
    }
  }

  @Test
  void aTurnThatLastsIsNoHangAndOtherDutiesGoOnMeanwhile() throws Exception {
    pool(1);
    Hanging other = new Hanging();
    AtomicBoolean lasts = new AtomicBoolean(true);
    AtomicInteger turns = new AtomicInteger();
    add(
        new TestDuty() {
          @Override
          public void turn(long nowNs) {
            turns.incrementAndGet();
            while (lasts.get() && !ends) {
              Thread.onSpinWait();
            }
          }
        });
    add(other);
    await("another thread has taken the others over", () -> other.turns.get() > 20);
    assertEquals(2, threads().size());
    assertEquals(1, turns.get());
    lasts.set(false);
    await("the duty goes on", () -> turns.get() > 20);
    await("the thread that wasn't missed ends", () -> threads().size() == 1);
    assertTrue(hanging.isEmpty());
    assertEquals(0, ended.get());
  }

  @Test
  void dutiesThatRestLeaveTheThreadsAsleepAndAWakeReachesEach() throws Exception {
    pool(2);
    List<AtomicInteger> turns = new ArrayList<>();
    for (int i = 0; i < 512; i++) {
      AtomicInteger count = new AtomicInteger();
      turns.add(count);
      add(
          new TestDuty() {
            @Override
            public void turn(long nowNs) {
              count.incrementAndGet();
            }

            @Override
            public long napNs(long nowNs) {
              return Long.MAX_VALUE;
            }
          });
    }
    await("each has had its first turn", () -> turns.stream().allMatch(n -> n.get() == 1));
    await("the threads sleep", DutyPoolTest::allWait);
    for (int i = 0; i < 512; i += 7) {
      int woken = i;
      shifts.get(i).wake();
      await("it has a turn", () -> turns.get(woken).get() == 2);
    }
    await("the threads sleep", DutyPoolTest::allWait);
    assertEquals(512 + 74, turns.stream().mapToInt(AtomicInteger::get).sum());
    assertFalse(threads().isEmpty());
  }

  private static boolean allWait() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> thread.getName().startsWith("carom-pooled"))
        .allMatch(thread -> thread.getState() == Thread.State.WAITING);
  }
}
