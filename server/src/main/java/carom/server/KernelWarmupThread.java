package carom.server;

import carom.physics.simd.VectorKernels;
import carom.physics.simd.VectorModule;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Warms vector kernels up on a thread of its own. Until they are compiled, all worlds of the JVM
 * step without them: a world's first seconds then neither wait for interpreted kernels nor allocate
 * the objects that these make. The bits are the same.
 *
 * <p>It begins when a world of the JVM has a step large enough for kernels. Rooms with a few dozen
 * bodies never have, and the warm-up would take from their ticks what it couldn't give back.
 *
 * <p>The thread steps a world of its own, which needs all kernels. That world warms them up as any
 * world does in a program without this thread: kernels first, then more and more of its work. What
 * is compiled allocates nothing; that is how the thread sees that the JIT compiler is done with the
 * kernels and with those that call them. The thread is a daemon of the lowest priority and ends
 * after some seconds of work. {@code docs/lab/kernels.md} has the measurements.
 */
final class KernelWarmupThread {
  /** Steps without allocation, in a row, after which the callers are compiled. */
  private static final int STILL_STEPS = 40;

  /** Steps after which the thread no longer waits for the compiler. */
  private static final int MOST_STEPS = 6_000;

  private final ThreadMXBean threads;
  private final Thread thread = new Thread(this::run, "carom-warm-up");
  private final List<VectorKernels> sets = new CopyOnWriteArrayList<>();

  /** Calls that the thread still waits for: {@link #begin}, and a world that wants it. */
  private final AtomicInteger missing = new AtomicInteger(2);

  private final AtomicBoolean wanted = new AtomicBoolean();
  private final CountDownLatch over = new CountDownLatch(1);
  private volatile boolean ended;

  private KernelWarmupThread(ThreadMXBean threads) {
    this.threads = threads;
    thread.setDaemon(true);
    thread.setPriority(Thread.MIN_PRIORITY);
  }

  /**
   * Keeps all worlds of this JVM from vector kernels until the warm-up that {@link #begin} starts
   * has ended. On a JVM that can't tell what a thread allocates, worlds go on to warm kernels up
   * themselves.
   *
   * @return what to begin when the program has time for it
   */
  public static KernelWarmupThread prepare() {
    boolean counts =
        ManagementFactory.getThreadMXBean() instanceof ThreadMXBean some
            && some.isThreadAllocatedMemorySupported()
            && some.isThreadAllocatedMemoryEnabled();
    KernelWarmupThread warmup =
        new KernelWarmupThread(counts ? (ThreadMXBean) ManagementFactory.getThreadMXBean() : null);
    if (counts) {
      Thread own = warmup.thread;
      VectorModule.leaveWarmUpTo(warmup::note, () -> Thread.currentThread() == own, warmup::want);
    }
    return warmup;
  }

  private void note(VectorKernels set) {
    sets.add(set);
    if (ended) {
      set.trust(); // found too late
    }
  }

  /** Lets the thread start from now on. Call it once. */
  public void begin() {
    if (threads != null) {
      startIfDue();
    }
  }

  private void want() {
    if (!wanted.get() && wanted.compareAndSet(false, true)) {
      startIfDue();
    }
  }

  private void startIfDue() {
    if (missing.decrementAndGet() == 0) {
      thread.start();
    }
  }

  /**
   * Waits for the end of the warm-up.
   *
   * @param ms how long at most
   * @return whether it has ended
   * @throws InterruptedException if the calling thread is interrupted
   */
  public boolean await(long ms) throws InterruptedException {
    return over.await(ms, TimeUnit.MILLISECONDS);
  }

  /** Returns whether a world has wanted kernels. */
  boolean isWanted() {
    return wanted.get();
  }

  private void run() {
    try {
      rehearse(new Rehearsal());
    } finally {
      ended = true;
      sets.forEach(VectorKernels::trust);
      over.countDown();
    }
  }

  /** Steps a world until all kernels do their work in it and its steps allocate nothing. */
  private void rehearse(Rehearsal rehearsal) {
    int still = 0;
    for (int i = 0; i < MOST_STEPS && still < STILL_STEPS && !sets.isEmpty(); i++) {
      boolean anew = rehearsal.isAtEnd();
      long bytes = threads.getCurrentThreadAllocatedBytes();
      rehearsal.step();
      boolean allocated = threads.getCurrentThreadAllocatedBytes() != bytes;
      boolean trusted = sets.stream().allMatch(VectorKernels::isTrusted);
      still = anew || allocated || !trusted ? 0 : still + 1;
    }
  }
}
