package carom.server.threads;

import java.util.function.BiConsumer;
import java.util.function.IntSupplier;

/**
 * Watches the thread that begins a server, until it has begun. Games are set up there, play for a
 * moment to warm up, and compute their logs again, before any room has a thread. It hangs if it
 * makes no progress for {@value Watchdog#LOAD_FOUND_MS} ms, in any code.
 */
public final class StartWatch implements AutoCloseable {
  private final Watchdog watchdog;

  /**
   * Begins to watch the calling thread.
   *
   * @param guard the class through which all calls of games go
   * @param progress returns a number that changes whenever the start gets on; any thread
   * @param hangs receives where the thread hangs, and its stack; another thread
   */
  public StartWatch(Class<?> guard, IntSupplier progress, BiConsumer<String, ThreadStack> hangs) {
    watchdog = new Watchdog(guard);
    watchdog.watchLoads(new Starter(Thread.currentThread()), new Start(progress, hangs));
    watchdog.start();
  }

  /** The thread, which never rests. */
  private record Starter(Thread thread) implements WatchedThread {
    @Override
    public boolean rests() {
      return false;
    }

    @Override
    public void onAwake(Runnable newOnAwake) {}
  }

  private record Start(IntSupplier steps, BiConsumer<String, ThreadStack> listener)
      implements Watchdog.Watched {
    @Override
    public int progress() {
      return steps.getAsInt();
    }

    @Override
    public void hangs(String callback, ThreadStack stack) {
      listener.accept(Watchdog.where(callback), stack);
    }
  }

  @Override
  public void close() {
    watchdog.close();
  }
}
