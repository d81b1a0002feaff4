package carom.physics.dynamics.domain;

import carom.physics.threads.Workers;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicIntegerArray;

/**
 * Runs the phases of a step side by side, each worker for its domain of the world. Workers wait for
 * each other only where domains meet. {@code docs/engine/THREADS.md} has a drawing.
 *
 * <p>A phase has two parts per domain. The <i>inner</i> part touches nothing that another domain
 * touches in any phase. The <i>border</i> part may touch what others touch in theirs, though not in
 * the same phase. So it waits until all others have done their border part of the phase before. A
 * worker that is ahead by less than an inner part never waits. A barrier after each phase would
 * make all wait for the slowest every time, and for lines of memory on their way between cores.
 *
 * <p>A worker does all phases of its own domain from when it comes. Until then, others do them one
 * by one where they would have to wait. So all is done however few threads come. A worker that has
 * to wait for long, because another one lost its processor, offers its own.
 *
 * <p>A phase costs a worker one store that the others see, and a look at each of them if it has a
 * border part. A claim per part would cost more, because it waits until all that was written before
 * has left for memory.
 *
 * <p>Which worker does what, and when, shows in no result. One thread adds and runs. Allocates only
 * when there are more phases or domains than ever before.
 */
public final class DomainPhases implements Workers.Task {
  /**
   * Ints between the progress of two domains: two cache lines, because they come in pairs. The
   * first ones stay unused, because all threads read the array's length beside them.
   */
  private static final int APART = 32;

  /** Looks for work before a thread offers its processor to others, some 100 us. */
  private static final int LOOKS_BEFORE_YIELD = 2_000;

  private Workers workers;
  private int domains = 1;

  /** The work of each phase. */
  private Phase[] phase = new Phase[64];

  /** The number that each phase was added with. */
  private int[] number = new int[64];

  private int phases;

  /** Per domain: how many phases have been begun. */
  private AtomicIntegerArray claimed = new AtomicIntegerArray(2 * APART);

  /** Per domain: how many phases are done. */
  private AtomicIntegerArray done = new AtomicIntegerArray(2 * APART);

  /** Tells whether a part threw. */
  private volatile boolean failed;

  /** Does the parts of a phase. */
  @FunctionalInterface
  public interface Phase {
    /**
     * Does a part of it.
     *
     * @param number what was {@link #add added} with it
     * @param domain from 0
     * @param border which part: false for inner, true for border
     * @param worker as in {@link Workers.Task}
     */
    void run(int number, int domain, boolean border, int worker);

    /**
     * Returns whether a border part does anything. A domain without one doesn't wait for the
     * others.
     *
     * @param number what was added with it
     * @param domain from 0
     * @return true unless it says otherwise
     */
    default boolean hasBorder(int number, int domain) {
      return true;
    }
  }

  /**
   * Sets how many domains there are, and forgets phases that were added and not run.
   *
   * @param count at least 1
   * @param parallel the threads that run them; may be null for one domain, which the caller runs
   */
  public void divide(int count, Workers parallel) {
    domains = count;
    workers = parallel;
    phases = 0;
    if (done.length() < (count + 1) * APART) {
      done = new AtomicIntegerArray((count + 1) * APART);
      claimed = new AtomicIntegerArray((count + 1) * APART);
    }
  }

  /**
   * Adds a phase. The next {@link #run} does it after all that were added before.
   *
   * @param what does it
   * @param given number that is handed on to it
   */
  public void add(Phase what, int given) {
    if (phases == phase.length) {
      phase = Arrays.copyOf(phase, 2 * phases);
      number = Arrays.copyOf(number, 2 * phases);
    }
    phase[phases] = what;
    number[phases++] = given;
  }

  /**
   * Does all phases that were added since the last time.
   *
   * @throws RuntimeException what a phase threw, likewise errors; some of the others were not done
   */
  public void run() {
    if (domains == 1) {
      for (int i = 0; i < phases; i++) {
        phase[i].run(number[i], 0, false, 0);
        phase[i].run(number[i], 0, true, 0);
      }
    } else if (phases > 0) {
      for (int domain = 0; domain < domains; domain++) {
        done.setPlain(place(domain), 0);
        claimed.setPlain(place(domain), 0);
      }
      failed = false;
      workers.run(domains, this);
    }
    phases = 0;
  }

  /**
   * Does the phases of a domain, and those of domains whose worker hasn't come, until all are done.
   * Called by {@link #run()} alone.
   */
  @Override
  public void run(int own, int worker) {
    int next = claimed.getAndSet(place(own), phases);
    boolean begun = false;
    int looks = 0;
    while (!failed) {
      boolean any = false;
      if (next < phases && done.getAcquire(place(own)) == next) { // else a helper is still at it
        if (!begun) {
          run(next, own, false, worker);
          begun = true;
          any = true;
        }
        if (mayEnd(next, own)) {
          run(next, own, true, worker);
          done.setRelease(place(own), ++next);
          begun = false;
          any = true;
        }
      }
      if (any || help(own, worker)) {
        looks = 0;
      } else if (next == phases && allClaimed()) {
        return;
      } else if (looks++ < LOOKS_BEFORE_YIELD) {
        Thread.onSpinWait();
      } else {
        if (looks == LOOKS_BEFORE_YIELD + 1) {
          workers.waits();
        }
        Thread.yield();
      }
    }
  }

  /** Does a phase of a domain whose worker hasn't come. Returns whether there was one to do. */
  private boolean help(int own, int worker) {
    for (int k = 1; k < domains; k++) {
      int other = own + k < domains ? own + k : own + k - domains;
      int next = claimed.get(place(other));
      if (next < phases
          && done.getAcquire(place(other)) == next
          && mayEnd(next, other)
          && claimed.compareAndSet(place(other), next, next + 1)) {
        run(next, other, false, worker);
        run(next, other, true, worker);
        done.setRelease(place(other), next + 1);
        return true;
      }
    }
    return false;
  }

  private boolean allClaimed() {
    for (int domain = 0; domain < domains; domain++) {
      if (claimed.get(place(domain)) < phases) {
        return false;
      }
    }
    return true;
  }

  private void run(int i, int domain, boolean border, int worker) {
    try {
      phase[i].run(number[i], domain, border, worker);
    } catch (RuntimeException | Error e) {
      failed = true; // the part will never be done, so no worker may wait for it
      throw e;
    }
  }

  /** Returns whether the others are as far as the border part of a phase needs them to be. */
  private boolean mayEnd(int i, int domain) {
    if (!phase[i].hasBorder(number[i], domain)) {
      return true;
    }
    for (int other = 0; other < domains; other++) {
      if (other != domain && done.getAcquire(place(other)) < i) {
        return false;
      }
    }
    return true;
  }

  private static int place(int domain) {
    return (domain + 1) * APART;
  }
}
