package carom.server.threads;

import java.util.function.BooleanSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A daemon thread that others rely on, and that no error ends: neither an exception nor too little
 * memory, a stack overflow or a missing class. The error is logged and the work goes on.
 */
public final class LastingThread {
  private static final Logger LOG = LoggerFactory.getLogger(LastingThread.class);

  /** Pause after an error, so that one that stays takes no processor and fills no disk, ms. */
  private static final long PAUSE_MS = 100;

  private LastingThread() {}

  /** A piece of the work. */
  @FunctionalInterface
  public interface Turn {
    /**
     * Does the piece, or waits for one.
     *
     * @throws InterruptedException to end the thread
     */
    void run() throws InterruptedException;
  }

  /**
   * Starts a thread that takes turn after turn.
   *
   * @param name name of the thread
   * @param lasts asked before each turn; false ends the thread
   */
  public static Thread start(String name, BooleanSupplier lasts, Turn turn) {
    Thread thread = new Thread(() -> live(lasts, turn), name);
    thread.setDaemon(true);
    thread.start();
    return thread;
  }

  /** Returns a task for an executor that would drop one that throws. */
  public static Runnable guarded(Runnable task) {
    return () -> {
      try {
        task.run();
      } catch (RuntimeException | Error e) {
        report(e);
      }
    };
  }

  private static void live(BooleanSupplier lasts, Turn turn) {
    while (lasts.getAsBoolean()) {
      try {
        turn.run();
      } catch (InterruptedException e) {
        return;
      } catch (RuntimeException | Error e) {
        report(e);
        try {
          Thread.sleep(PAUSE_MS);
        } catch (InterruptedException ended) {
          return;
        }
      }
    }
  }

  private static void report(Throwable e) {
    try {
      LOG.error("{} failed, and goes on", Thread.currentThread().getName(), e);
    } catch (RuntimeException | Error again) {
      return; // too little memory even for the log: there may be more later
    }
  }
}
