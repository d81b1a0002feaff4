package carom.server.threads;

import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * Builds the matches that rooms go on with: on a thread of its own, so that no tick waits, or at
 * once on the caller's thread while no threads drive the server. Any thread.
 */
public final class LoaderThread implements Executor, AutoCloseable {
  private ExecutorService thread;
  private volatile boolean hasThread;

  /** Creates an executor that runs tasks on the calling thread. */
  public LoaderThread() {}

  /** Lets tasks run on a thread of their own from now on. The first one starts it. */
  public void start() {
    hasThread = true;
  }

  @Override
  public void execute(Runnable task) {
    if (hasThread) {
      thread().execute(task);
    } else {
      task.run();
    }
  }

  private synchronized ExecutorService thread() {
    if (thread == null) {
      thread =
          Executors.newSingleThreadExecutor(
              task -> {
                Thread created = new Thread(task, "carom-loader");
                created.setDaemon(true);
                return created;
              });
    }
    return thread;
  }

  @Override
  public synchronized void close() {
    if (thread != null) {
      thread.shutdownNow();
    }
  }
}
