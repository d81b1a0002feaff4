package carom.server.threads;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Goal: a thread that doesn't come back from a game's code is found, and no other. */
@Timeout(60)
class WatchdogTest {
  private volatile boolean ends;
  private final AtomicInteger progress = new AtomicInteger();
  private Watchdog watchdog;
  private DutyPool pool;
  private DutyPool.Shift shift;
  private final CompletableFuture<String> found = new CompletableFuture<>();

  @AfterEach
  void end() {
    ends = true;
    watchdog.close();
    shift.stop();
    shift.join(System.nanoTime() + TimeUnit.SECONDS.toNanos(5));
    pool.close();
  }

  /** Stands for the class through which all calls of games go. */
  static final class Guard {
    private Guard() {}

    static void call(Runnable game) {
      game.run();
    }
  }

  private TestDuty duty(Runnable turn, long napNs) {
    return new TestDuty() {
      @Override
      public void turn(long nowNs) {
        turn.run();
      }

      @Override
      public long napNs(long nowNs) {
        return napNs;
      }

      @Override
      public int progress() {
        return progress.get();
      }
    };
  }

  private void watch(Runnable turn) {
    watch(turn, 1_000_000);
  }

  private void watch(Runnable turn, long napNs) {
    watchdog = new Watchdog(Guard.class);
    pool = new DutyPool("carom-watched", 1, Thread.NORM_PRIORITY, System::nanoTime, watchdog);
    shift =
        pool.add(
            "what is watched",
            duty(turn, napNs),
            0,
            (thread, callback, stack) ->
                found.complete(callback + "\n" + Arrays.toString(stack.getStackTrace())),
            ended -> {});
    watchdog.start();
  }

  private String foundWithin(int ms) throws Exception {
    try {
      return found.get(ms, TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      return null;
    }
  }

  private void spin() {
    while (!ends) {
      Thread.onSpinWait();
    }
  }

  private void sleep() {
    while (!ends) {
      LockSupport.parkNanos(100_000_000L);
    }
  }

  @Test
  void aCallbackThatLoopsIsFoundAndNamedWithItsStack() throws Exception {
    watch(() -> Guard.call(this::spin));
    String text = foundWithin(30_000); // 2 s by the watchdog's own looks; this machine may be busy
    assertTrue(text != null && text.startsWith("call of "), "" + text);
    assertTrue(text.contains("WatchdogTest.spin"), text);
  }

  @Test
  void aCallbackThatWaitsIsFound() throws Exception {
    watch(() -> Guard.call(this::sleep));
    String text = foundWithin(30_000);
    assertTrue(text != null && text.contains("WatchdogTest.sleep"), "" + text);
  }

  @Test
  void aCallbackThatLoopsAfterALongNapIsFound() throws Exception {
    CountDownLatch first = new CountDownLatch(1);
    watch(
        () -> {
          if (first.getCount() > 0) {
            first.countDown();
          } else {
            Guard.call(this::spin);
          }
        },
        Long.MAX_VALUE);
    first.await();
    while (!rests("carom-watched")) {
      Thread.onSpinWait();
    }
    assertNull(foundWithin(Watchdog.FOUND_MS)); // the watchdog waits as well meanwhile
    shift.wake();
    String text = foundWithin(30_000);
    assertTrue(text != null && text.contains("WatchdogTest.spin"), "" + text);
  }

  private static boolean rests(String name) {
    return Thread.getAllStackTraces().keySet().stream()
        .anyMatch(t -> t.getName().equals(name) && t.getState() == Thread.State.WAITING);
  }

  @Test
  void workOutsideOfAGameIsNotFound() throws Exception {
    watch(this::sleep);
    assertNull(foundWithin(Watchdog.FOUND_MS + 1_500));
  }

  @Test
  void aGameThatGetsOnIsNotFound() throws Exception {
    watch(
        () ->
            Guard.call(
                () -> {
                  while (!ends) {
                    progress.incrementAndGet();
                    LockSupport.parkNanos(20_000_000L);
                  }
                }));
    assertNull(foundWithin(Watchdog.FOUND_MS + 1_500));
    assertEquals(0, found.getNumberOfDependents());
  }
}
