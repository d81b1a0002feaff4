package carom.client.app;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Lets a program that is asked to stop (Ctrl-C, SIGTERM) leave the game first, so that its players'
 * places are free at once.
 *
 * <p>The loop asks {@link #asked} once per turn; {@link #close} says that everybody has left. Any
 * thread.
 */
public final class StopSignal implements AutoCloseable {
  private static final long LONGEST_GOODBYE_MS = 1_500;

  private final CountDownLatch left = new CountDownLatch(1);
  private final Thread hook = new Thread(this::askAndWait, "carom-stop");
  private volatile boolean asked;

  /** Listens from now on. */
  public StopSignal() {
    Runtime.getRuntime().addShutdownHook(hook);
  }

  /** Whether the program should come to its end. */
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

  /** The players have left: the program may end. */
  @Override
  public void close() {
    left.countDown();
    if (!asked) {
      try {
        Runtime.getRuntime().removeShutdownHook(hook);
      } catch (IllegalStateException e) {
        asked = true; // the program is ending this very moment
      }
    }
  }
}
