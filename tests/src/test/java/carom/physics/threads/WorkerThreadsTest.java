package carom.physics.threads;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.suite.Needs;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Each task runs once, on any thread. */
@Needs("waits")
final class WorkerThreadsTest {
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 5})
  void everyTaskIsDoneOnceAndSeenByTheCaller(int count) {
    try (WorkerThreads workers = new WorkerThreads(count)) {
      assertEquals(count, workers.count());
      for (int tasks : new int[] {0, 1, 2, 3, 7, 64, 1023, 1024, 1025, 5000}) {
        for (int round = 1; round <= 50; round++) {
          int[] done = new int[tasks]; // plain memory: run must order it
          workers.run(tasks, (task, worker) -> done[task]++);
          int[] once = new int[tasks];
          Arrays.fill(once, 1);
          assertArrayEquals(once, done, "tasks=" + tasks);
        }
      }
    }
  }

  @Test
  void whatOneRunWroteTheNextOneReads() {
    try (WorkerThreads workers = new WorkerThreads(3)) {
      int size = 60;
      long[][] rows = new long[2][size];
      Arrays.setAll(rows[0], i -> i);
      for (int round = 0; round < 20_000; round++) {
        long[] from = rows[round & 1];
        long[] to = rows[1 - (round & 1)];
        workers.run(
            size, (i, worker) -> to[i] = from[(i + 1) % size] * 31 + from[(i + size - 1) % size]);
      }
      long[][] alone = new long[2][size];
      Arrays.setAll(alone[0], i -> i);
      for (int round = 0; round < 20_000; round++) {
        for (int i = 0; i < size; i++) {
          alone[1 - (round & 1)][i] =
              alone[round & 1][(i + 1) % size] * 31 + alone[round & 1][(i + size - 1) % size];
        }
      }
      assertArrayEquals(alone[0], rows[0]);
    }
  }

  @Test
  void noTwoTasksAtOnceHaveTheSameWorker() {
    try (WorkerThreads workers = new WorkerThreads(3)) {
      AtomicIntegerArray busy = new AtomicIntegerArray(3);
      AtomicInteger clashes = new AtomicInteger();
      for (int round = 0; round < 2000; round++) {
        workers.run(
            30,
            (task, worker) -> {
              if (busy.incrementAndGet(worker) > 1) {
                clashes.incrementAndGet();
              }
              busy.decrementAndGet(worker);
            });
      }
      assertEquals(0, clashes.get());
    }
  }

  /** Both tasks must be under way before either may end. */
  @Test
  void threadsHelp() {
    try (WorkerThreads workers = new WorkerThreads(2)) {
      CountDownLatch both = new CountDownLatch(2);
      Thread[] who = new Thread[2];
      workers.run(
          2,
          (task, worker) -> {
            who[task] = Thread.currentThread();
            both.countDown();
            awaitQuietly(both);
          });
      assertFalse(who[0] == who[1]);
      assertTrue(who[0] == Thread.currentThread() || who[1] == Thread.currentThread());
    }
  }

  @Test
  void parkedThreadsWakeAndParkedCallersToo() throws InterruptedException {
    try (WorkerThreads workers = new WorkerThreads(2)) {
      for (int round = 0; round < 20; round++) {
        Thread.sleep(2);
        CountDownLatch both = new CountDownLatch(2);
        workers.run(
            2,
            (task, worker) -> {
              both.countDown();
              awaitQuietly(both);
              if (worker == 1) {
                sleepQuietly();
              }
            });
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 40, 79})
  void anExceptionSurfacesAfterAllTasksHaveEnded(int bad) {
    try (WorkerThreads workers = new WorkerThreads(2)) {
      IllegalStateException thrown = new IllegalStateException("as planned");
      AtomicInteger begun = new AtomicInteger();
      AtomicInteger ended = new AtomicInteger();
      IllegalStateException caught =
          assertThrows(
              IllegalStateException.class,
              () ->
                  workers.run(
                      80,
                      (task, worker) -> {
                        begun.incrementAndGet();
                        if (task == bad) {
                          throw thrown;
                        }
                        ended.incrementAndGet();
                      }));
      assertSame(thrown, caught);
      assertEquals(80, begun.get());
      assertEquals(79, ended.get());
      AtomicInteger after = new AtomicInteger();
      workers.run(80, (task, worker) -> after.incrementAndGet());
      assertEquals(80, after.get());
    }
  }

  @Test
  void anErrorSurfaces() {
    try (WorkerThreads workers = new WorkerThreads(2)) {
      assertThrows(
          StackOverflowError.class,
          () ->
              workers.run(
                  9,
                  (task, worker) -> {
                    throw new StackOverflowError();
                  }));
    }
  }

  /** The second caller finds the threads busy and does its tasks alone. */
  @Test
  void callersShare() throws InterruptedException {
    try (WorkerThreads workers = new WorkerThreads(2)) {
      AtomicInteger wrong = new AtomicInteger();
      Runnable caller =
          () -> {
            for (int round = 0; round < 5000; round++) {
              int[] done = new int[8];
              workers.run(8, (task, worker) -> done[task]++);
              for (int d : done) {
                wrong.addAndGet(d - 1);
              }
            }
          };
      Thread other = new Thread(caller);
      other.start();
      caller.run();
      other.join();
      assertEquals(0, wrong.get());
    }
  }

  /** Who announced a step has the threads until it ends; others, and their hints, wait for none. */
  @Test
  void anAnnouncedStepHasTheThreadsToItself() throws InterruptedException {
    try (WorkerThreads workers = new WorkerThreads(2)) {
      Workers.Task meeting = meeting(workers);
      workers.stepBegins();
      Thread other =
          new Thread(
              () -> {
                workers.stepBegins();
                Thread me = Thread.currentThread();
                workers.run(8, (task, worker) -> assertSame(me, Thread.currentThread()));
                workers.stepEnds();
              });
      AtomicInteger failures = new AtomicInteger();
      other.setUncaughtExceptionHandler((t, e) -> failures.incrementAndGet());
      other.start();
      other.join();
      assertEquals(0, failures.get());
      workers.run(2, meeting);
      workers.stepEnds();
      Thread third = new Thread(() -> workers.run(2, meeting(workers)));
      third.start();
      third.join();
    }
  }

  /** A step that is better done alone leaves the threads to others. */
  @Test
  void aStepDoneAloneHasNoThreads() throws InterruptedException {
    AtomicLong now = new AtomicLong();
    try (WorkerThreads workers = new WorkerThreads(2, () -> now.addAndGet(1_000_000))) {
      workers.stepBegins();
      CountDownLatch helped = new CountDownLatch(1);
      workers.run(
          2,
          (task, worker) -> {
            if (worker == 0) {
              awaitQuietly(helped);
              return;
            }
            long before = now.get();
            helped.countDown();
            while (now.get() == before) { // until the caller looks how long it waits
              Thread.onSpinWait();
            }
          });
      workers.stepEnds();
      Thread me = Thread.currentThread();
      for (int left = Sharing.TRIAL_STEPS - 1; left >= 0; left--) {
        workers.stepBegins();
        if (Integer.bitCount(left) % 2 == 0) {
          workers.run(2, meeting(workers)); // would never end alone
        } else {
          workers.run(20, (task, worker) -> assertSame(me, Thread.currentThread()));
          Thread other =
              new Thread(
                  () -> {
                    workers.stepBegins();
                    workers.run(2, meeting(workers));
                    workers.stepEnds();
                  });
          other.start();
          other.join();
        }
        workers.stepEnds();
      }
    }
  }

  /** Each decides for itself, also when one thread steps both, or several step one. */
  @Test
  void worldsDecideForThemselvesWhetherSharingPays() throws InterruptedException {
    try (WorkerThreads workers = new WorkerThreads(2, () -> 0)) {
      Workers waits = workers.forOneWorld();
      Workers other = workers.forOneWorld();
      waits.stepBegins();
      waits.run(2, (task, worker) -> waits.waits());
      waits.stepEnds();
      Thread me = Thread.currentThread();
      for (int left = Sharing.TRIAL_STEPS - 1; left >= 0; left--) {
        Thread next =
            new Thread(
                () -> {
                  waits.stepBegins();
                  waits.stepEnds();
                });
        other.stepBegins();
        other.run(2, meeting(workers)); // would never end alone
        other.stepEnds();
        if (left % 3 == 0) {
          next.start();
          next.join();
          continue;
        }
        waits.stepBegins();
        if (Integer.bitCount(left) % 2 == 0) {
          waits.run(2, meeting(workers));
        } else {
          waits.run(20, (task, worker) -> assertSame(me, Thread.currentThread()));
        }
        waits.stepEnds();
      }
    }
  }

  /** Two tasks that end only if two threads do them. */
  private static Workers.Task meeting(WorkerThreads workers) {
    CountDownLatch both = new CountDownLatch(workers.count());
    return (task, worker) -> {
      both.countDown();
      awaitQuietly(both);
    };
  }

  /** Steps that end by an exception, and those of other worlds that share the threads. */
  @Test
  void hintsInAnyOrderChangeNothing() {
    try (WorkerThreads workers = new WorkerThreads(2)) {
      for (int round = 0; round < 200; round++) {
        if (round % 3 != 0) {
          workers.stepBegins();
        }
        int[] done = new int[8];
        workers.run(8, (task, worker) -> done[task]++);
        assertArrayEquals(new int[] {1, 1, 1, 1, 1, 1, 1, 1}, done);
        if (round % 5 != 0) {
          workers.stepEnds();
        }
      }
    }
  }

  @Test
  void afterClosingTheCallerIsAlone() {
    WorkerThreads workers = new WorkerThreads(3);
    workers.close();
    Thread me = Thread.currentThread();
    int[] done = {0};
    workers.run(
        100,
        (task, worker) -> {
          assertSame(me, Thread.currentThread());
          assertEquals(0, worker);
          done[0]++;
        });
    assertEquals(100, done[0]);
    workers.close();
  }

  @Test
  void runsAllocateNothing() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    int[] done = new int[64];
    Workers.Task task = (i, worker) -> done[i]++;
    try (WorkerThreads workers = new WorkerThreads(2)) {
      for (int i = 0; i < 2000; i++) {
        workers.run(64, task);
      }
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < 2000; i++) {
        workers.run(64, task);
      }
      assertTrue(threads.getCurrentThreadAllocatedBytes() - before < 2000);
    }
  }

  @Test
  void countHasLimits() {
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> new WorkerThreads(0));
    assertEquals(
        "count=0 is outside 1..64; it is the number of threads, the caller included",
        e.getMessage());
    assertThrows(IllegalArgumentException.class, () -> new WorkerThreads(65));
  }

  private static void awaitQuietly(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  private static void sleepQuietly() {
    try {
      Thread.sleep(2);
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }
}
