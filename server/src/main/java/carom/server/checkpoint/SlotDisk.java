package carom.server.checkpoint;

import carom.replay.Recorder;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Writes the checkpoints of all rooms. After {@link #start} two threads do it: one compresses and
 * writes, the other waits until the disk has what was written, so that no log waits with it. Before
 * that, all happens at once on the caller's thread, so that servers driven by hand do the same in
 * each run. Any thread.
 */
public final class SlotDisk implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(SlotDisk.class);
  private static final long CLOSE_S = 5;

  private final ExecutorService writes = thread("carom-checkpoints");
  private final ExecutorService syncs = thread("carom-checkpoints-sync");

  private final int mostStateBytes;
  private final int blocksPerSecond;
  private final Executor byHand;
  private volatile boolean hasThreads;

  /** Creates a disk without threads. */
  public SlotDisk() {
    this(Runnable::run);
  }

  /**
   * Creates a disk as above.
   *
   * @param mostStateBytes largest state of a room that is kept, bytes
   */
  public SlotDisk(int mostStateBytes) {
    this(mostStateBytes, Recorder.Intervals.LOG.blocksPerSecond(), Runnable::run);
  }

  /**
   * Creates a disk as above.
   *
   * @param byHand runs each step of writing before {@link #start}, at once and in order
   */
  public SlotDisk(Executor byHand) {
    this(Recorder.MOST_STATE_BYTES, Recorder.Intervals.LOG.blocksPerSecond(), byHand);
  }

  private SlotDisk(int mostStateBytes, int blocksPerSecond, Executor byHand) {
    this.mostStateBytes = mostStateBytes;
    this.blocksPerSecond = blocksPerSecond;
    this.byHand = byHand;
  }

  /**
   * Returns a disk for journals that go to other servers, which write each tick by itself.
   *
   * @param tickRateHz ticks per second
   */
  public static SlotDisk ofFollowers(int tickRateHz) {
    return new SlotDisk(Recorder.MOST_STATE_BYTES, tickRateHz, Runnable::run);
  }

  /** Lets threads write from now on. They begin with the first task. */
  public void start() {
    hasThreads = true;
  }

  /** Returns how logs behind checkpoints are written. */
  Recorder.Intervals pace() {
    Recorder.Intervals log = Recorder.Intervals.LOG;
    return new Recorder.Intervals(
        blocksPerSecond, log.keyframeSeconds(), log.stateSeconds(), mostStateBytes);
  }

  private static ExecutorService thread(String name) {
    AtomicInteger number = new AtomicInteger();
    return Executors.newSingleThreadExecutor(
        task -> {
          // After a task that threw, the next one gets a new thread.
          String suffix = number.incrementAndGet() == 1 ? "" : "-" + number.get();
          Thread thread = new Thread(task, name + suffix);
          thread.setDaemon(true);
          return thread;
        });
  }

  /** Writes after all that was asked for before. */
  public void write(Runnable task) {
    run(task, writes);
  }

  /** Syncs after all that was asked for before. */
  void sync(Runnable task) {
    run(task, syncs);
  }

  private void run(Runnable task, ExecutorService thread) {
    if (hasThreads) {
      try {
        thread.execute(task);
      } catch (RejectedExecutionException e) {
        LOG.debug("a journal goes on whose disk is closed, until its room gets another");
      }
    } else {
      byHand.execute(task);
    }
  }

  /**
   * Waits for at most 5 s until all that was asked for is written, so that it can be read.
   *
   * @return whether it is
   */
  public boolean flush() {
    CountDownLatch written = new CountDownLatch(1);
    write(written::countDown);
    try {
      return written.await(CLOSE_S, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /** Waits for at most 5 s until all that was asked for is on the disk, and ends the threads. */
  @Override
  public void close() {
    try {
      writes.shutdown();
      boolean written = writes.awaitTermination(CLOSE_S, TimeUnit.SECONDS);
      syncs.shutdown();
      if (!written || !syncs.awaitTermination(CLOSE_S, TimeUnit.SECONDS)) {
        LOG.error("the last checkpoints are incomplete: the disk did not take them in time");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
