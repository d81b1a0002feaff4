package carom.server.threads;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.IntSupplier;

/**
 * Builds the matches that rooms go on with: on a thread of its own, so that no tick waits, or at
 * once on the caller's thread while no threads drive the server. A thread that doesn't come back
 * from a match is abandoned, and another one goes on with those that wait. Any thread.
 */
public final class LoaderThread implements AutoCloseable {
  private static final String NAME = "carom-loader";
  private static final String ENDS = "the server ends";

  /** A match that is built when it runs. */
  public interface Load extends Runnable {
    /**
     * Returns work whose outcome isn't awaited.
     *
     * @param title as {@link #title}
     * @param progress as {@link #progress}
     */
    static Load of(String title, IntSupplier progress, Runnable work) {
      return new Load() {
        @Override
        public String title() {
          return title;
        }

        @Override
        public int progress() {
          return progress.getAsInt();
        }

        @Override
        public void run() {
          work.run();
        }
      };
    }

    /** Returns room, game and level, for people; any thread. */
    String title();

    /** Returns a number that changes whenever the work gets on; the watchdog's thread. */
    default int progress() {
      return 0;
    }

    /**
     * Hears that the thread doesn't come back and is abandoned: what it brings later is of no use.
     * The watchdog's thread.
     *
     * @param why for people
     */
    default void abandoned(String why) {}

    /**
     * Hears that the match isn't awaited any longer; the thread that asks, or that closes.
     *
     * @param why for people
     */
    default void cancelled(String why) {}
  }

  /** Hears of threads that are abandoned. */
  @FunctionalInterface
  public interface Listener {
    /**
     * Receives a thread that doesn't come back. The watchdog's thread.
     *
     * @param load what it builds
     * @param thread its name
     * @param where the method of the game that doesn't return, for people
     * @param stack of the thread
     */
    void abandoned(Load load, String thread, String where, ThreadStack stack);
  }

  private final BlockingQueue<Task> waiting = new LinkedBlockingQueue<>();
  private Watchdog watchdog;
  private Listener listener;
  private Builder builder;
  private int taken;
  private boolean closed;
  private volatile boolean hasThread;

  /** Creates an object that builds on the calling thread. */
  public LoaderThread() {}

  /**
   * Begins to build matches on a thread of their own. The first one starts it.
   *
   * @param newWatchdog looks at the thread while it builds
   */
  public synchronized void start(Watchdog newWatchdog, Listener newListener) {
    watchdog = newWatchdog;
    listener = newListener;
    hasThread = true;
  }

  /** Builds a match, after those that were asked for before. */
  public void execute(Load load) {
    if (!hasThread) {
      load.run();
      return;
    }
    synchronized (this) {
      if (!closed) {
        taken++;
        waiting.add(new Task(load, LastingThread.guarded(load), taken));
        if (builder == null) {
          begin();
        }
        return;
      }
    }
    load.cancelled(ENDS);
  }

  private void begin() {
    builder = new Builder();
    watchdog.watchLoads(builder, builder);
    builder.thread.start();
  }

  private synchronized void replace() {
    if (!closed) {
      begin();
    }
  }

  @Override
  public void close() {
    List<Task> left = new ArrayList<>();
    synchronized (this) {
      closed = true;
      waiting.drainTo(left);
      if (builder != null) {
        Task present = builder.present.get();
        if (present != null) {
          left.add(present);
        }
        builder.thread.interrupt();
      }
    }
    left.forEach(task -> task.load().cancelled(ENDS)); // who waits for one mustn't wait for ever
  }

  private synchronized boolean isClosed() {
    return closed;
  }

  /** A match that waits or is built, and its number from 1 on. */
  private record Task(Load load, Runnable work, int number) {}

  /** One thread, until it is abandoned. */
  private final class Builder implements WatchedThread, Watchdog.Watched {
    private final Thread thread = new Thread(this::run, NAME);

    /** Null while nothing is built, and when the thread is abandoned. */
    private final AtomicReference<Task> present = new AtomicReference<>();

    /** The task that the last look saw, or null. The watchdog's thread only. */
    private Task seen;

    private volatile Runnable onAwake = () -> {};

    Builder() {
      thread.setDaemon(true);
    }

    private void run() {
      while (!isClosed()) {
        Task task;
        try {
          task = waiting.take();
        } catch (InterruptedException e) {
          return;
        }
        present.set(task);
        onAwake.run();
        task.work().run();
        if (!present.compareAndSet(task, null)) {
          return; // another thread has its place
        }
      }
    }

    @Override
    public Thread thread() {
      return thread;
    }

    @Override
    public boolean rests() {
      return present.get() == null;
    }

    @Override
    public void onAwake(Runnable newOnAwake) {
      onAwake = newOnAwake;
    }

    @Override
    public int progress() {
      seen = present.get();
      return seen == null ? 0 : 31 * seen.number() + seen.load().progress();
    }

    @Override
    public void hangs(String callback, ThreadStack stack) {
      Task task = seen;
      if (task == null || !present.compareAndSet(task, null)) {
        watchdog.watchLoads(this, this); // it has come back in this moment
        return;
      }
      replace();
      thread.setPriority(Thread.MIN_PRIORITY);
      String where = Watchdog.where(callback);
      listener.abandoned(task.load(), thread.getName(), where, stack);
      task.load().abandoned("its set-up hangs in " + where);
    }
  }
}
