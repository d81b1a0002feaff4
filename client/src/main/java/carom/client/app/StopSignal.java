package carom.client.app;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Delays the end of a program that is asked to stop (Ctrl-C, SIGTERM) until its players have left
 * the game, so that their places are free at once.
 *
 * <p>The program's loop checks {@link #asked} once per turn, and calls {@link #close} when all
 * players have left. Thread-safe.
 */
public final class StopSignal implements AutoCloseable {
  private static final long LONGEST_GOODBYE_MS = 1_500;

  private final CountDownLatch left = new CountDownLatch(1);
  private final Thread hook = new Thread(this::askAndWait, "carom-stop");
  private volatile boolean asked;

  /** Starts to listen for the request to stop. */
  public StopSignal() {
    Runtime.getRuntime().addShutdownHook(hook);
  }

  /** Returns whether the program was asked to stop. */
  public boolean asked() {
    return asked;
  }

  private void askAndWait() {
    asked = true;
    try {
      if (!left.await(LONGEST_GOODBYE_MS, TimeUnit.MILLISECONDS)) {
        System.err.println("stopped without a goodbye after " + LONGEST_GOODBYE_MS + " ms");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Lets the program end: the players have left. */
  @Override
  public void close() {
    left.countDown();
    if (!asked) {
      try {
        Runtime.getRuntime().removeShutdownHook(hook);
      } catch (IllegalStateException e) {
        asked = true; // the program is already ending
      }
    }
  }
}
