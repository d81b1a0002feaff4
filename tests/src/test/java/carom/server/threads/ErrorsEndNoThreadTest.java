package carom.server.threads;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.frame.DatagramPort;
import carom.server.command.Caller;
import carom.server.command.Command;
import carom.server.command.CommandRegistry;
import carom.suite.Needs;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: no error ends a thread on which others rely without a word. Method: each kind of work
 * throws what the JVM throws when memory, stack or classes are missing, and has to go on, or to say
 * that it ends.
 */
@Needs("sockets")
@Timeout(60)
final class ErrorsEndNoThreadTest {
  private static final List<Throwable> ERRORS =
      List.of(
          new OutOfMemoryError("on purpose"),
          new StackOverflowError("on purpose"),
          new NoClassDefFoundError("on purpose"),
          new ExceptionInInitializerError("on purpose"),
          new AssertionError("on purpose"),
          new IllegalStateException("on purpose"));

  /** Throws each of the errors once, and does its work from then on. */
  private static final class Faulty {
    private final AtomicInteger turns = new AtomicInteger();
    private final CountDownLatch works = new CountDownLatch(1);

    void run() {
      int turn = turns.getAndIncrement();
      if (turn < ERRORS.size()) {
        if (ERRORS.get(turn) instanceof Error error) {
          throw error;
        }
        throw (RuntimeException) ERRORS.get(turn);
      }
      works.countDown();
    }

    void assertWorks() throws InterruptedException {
      assertTrue(works.await(30, TimeUnit.SECONDS), "turns=" + turns);
    }
  }

  @Test
  void aLastingThreadGoesOnAndEndsWhenItShould() throws Exception {
    Faulty faulty = new Faulty();
    AtomicBoolean lasts = new AtomicBoolean(true);
    Thread thread = LastingThread.start("carom-test", lasts::get, faulty::run);
    faulty.assertWorks();
    lasts.set(false);
    thread.join(10_000);
    assertFalse(thread.isAlive());
  }

  @Test
  void aGuardedTaskIsRepeatedByItsExecutor() throws Exception {
    Faulty faulty = new Faulty();
    ScheduledExecutorService clock = Executors.newScheduledThreadPool(1);
    try {
      var unused =
          clock.scheduleAtFixedRate(
              LastingThread.guarded(faulty::run), 1, 1, TimeUnit.MILLISECONDS);
      faulty.assertWorks();
    } finally {
      clock.shutdownNow();
    }
  }

  @Test
  void theSocketOfAllPlayersIsReadOn() throws Exception {
    Faulty faulty = new Faulty();
    Queue<Throwable> reported = new ConcurrentLinkedQueue<>();
    InetAddress loopback = InetAddress.getLoopbackAddress();
    DatagramPort port =
        new DatagramPort(
            List.of(loopback), 0, 100, (from, bytes, now) -> faulty.run(), reported::add);
    port.start();
    try (DatagramSocket socket = new DatagramSocket()) {
      for (int i = 0; i < 1_000 && faulty.works.getCount() > 0; i++) {
        socket.send(new DatagramPacket(new byte[1], 1, loopback, port.number()));
        Thread.sleep(2);
      }
      faulty.assertWorks();
    } finally {
      port.close();
    }
    assertEquals(ERRORS, List.copyOf(reported));
  }

  @Test
  void aCommandThatFailsIsAnsweredAndTheConsoleReadsOn() throws Exception {
    Faulty faulty = new Faulty();
    CommandRegistry commands = new CommandRegistry();
    commands.add(
        new Command(
            "work",
            "",
            "Works.",
            words -> {
              faulty.run();
              return "done";
            },
            Command.NONE));
    for (Throwable error : ERRORS) {
      CommandRegistry.Answer answer = commands.run("work", Caller.CONSOLE);
      assertFalse(answer.ok());
      assertTrue(answer.text().contains(error.toString()), answer.text());
    }
    assertEquals("done", commands.run("work", Caller.CONSOLE).text());
  }

  @Test
  void theLoaderTakesTheNextMatch() throws Exception {
    Faulty faulty = new Faulty();
    Watchdog watchdog = new Watchdog(ErrorsEndNoThreadTest.class);
    try (LoaderThread loader = new LoaderThread()) {
      loader.start(watchdog, (load, thread, where, stack) -> {});
      for (int i = 0; i <= ERRORS.size(); i++) {
        loader.execute(LoaderThread.Load.of("faulty", () -> 0, faulty::run));
      }
      faulty.assertWorks();
    }
  }

  @Test
  void theWatchdogLooksOn() throws Exception {
    Faulty faulty = new Faulty();
    try (Watchdog watchdog = new Watchdog(ErrorsEndNoThreadTest.class)) {
      watchdog.watch(
          new Unstarted(new Thread("carom-watched")),
          new Watchdog.Watched() {
            @Override
            public int progress() {
              faulty.run();
              return faulty.turns.get();
            }

            @Override
            public void hangs(String callback, ThreadStack stack) {}
          });
      watchdog.start();
      faulty.assertWorks();
    }
  }

  /** A thread that never runs. */
  private record Unstarted(Thread thread) implements WatchedThread {
    @Override
    public boolean rests() {
      return false;
    }

    @Override
    public void onAwake(Runnable newOnAwake) {}
  }

  /** An error ends one room with its links, and the server hears of it; the others go on. */
  @Test
  void aRoomThatAnErrorEndsSaysSoAndItsThreadRunsTheOthers() throws Exception {
    DutyPool pool = new DutyPool("carom-test", 1, Thread.NORM_PRIORITY, System::nanoTime, null);
    CountDownLatch turnsOfOther = new CountDownLatch(1_000);
    pool.add(
        "the other",
        new TestDuty() {
          @Override
          public void turn(long nowNs) {
            turnsOfOther.countDown();
          }
        },
        0,
        (thread, callback, stack) -> {},
        shift -> {});
    for (Throwable error : ERRORS) {
      FaultyDuty duty = new FaultyDuty(error);
      CountDownLatch ended = new CountDownLatch(1);
      DutyPool.Shift shift =
          pool.add("a room", duty, 0, (thread, callback, stack) -> {}, over -> ended.countDown());
      boolean goesOn = error instanceof RuntimeException || error instanceof StackOverflowError;
      if (goesOn) {
        assertTrue(duty.again.await(30, TimeUnit.SECONDS), "" + error);
        shift.stop();
      }
      assertTrue(ended.await(30, TimeUnit.SECONDS), "" + error);
      List<String> end = List.of("links closed");
      assertEquals(goesOn ? end : List.of("an error ended it", "links closed"), duty.said());
    }
    assertTrue(turnsOfOther.await(30, TimeUnit.SECONDS), "" + turnsOfOther);
    pool.close();
  }

  /** Throws once, and then works. */
  private static final class FaultyDuty extends TestDuty {
    private final AtomicBoolean thrown = new AtomicBoolean();
    private final CountDownLatch again = new CountDownLatch(1);
    private final Queue<String> said = new ConcurrentLinkedQueue<>();
    private final Throwable error;

    FaultyDuty(Throwable error) {
      this.error = error;
    }

    List<String> said() {
      return List.copyOf(said);
    }

    @Override
    public void turn(long nowNs) {
      if (error != null && thrown.compareAndSet(false, true)) {
        if (error instanceof Error e) {
          throw e;
        }
        throw (RuntimeException) error;
      }
      again.countDown();
    }

    @Override
    public void fail(String why) {
      said.add(why);
    }

    @Override
    public void closeLinks() {
      said.add("links closed");
    }
  }
}
