package carom.physics.dynamics.domain;

import carom.physics.threads.Workers;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicIntegerArray;

/**
 * Has {@link Workers} do the phases of a step side by side, each for a domain of the world, and
 * wait for each other only where domains meet.
 *
 * <p>A phase has two parts per domain. The <i>inner</i> part touches nothing that another domain
 * touches in any phase. The <i>border</i> part may touch what others do in theirs, though not in
 * the same phase: so it waits until all others have done their border part of the phase before. Who
 * is ahead by less than an inner part thus never waits, where a barrier after each phase would have
 * everybody wait for the slowest every time, and for lines of memory on their way between cores.
 *
 * <p>A worker does all phases of its own domain from when it comes, and until then others do them
 * one by one where they would have to wait. So all is done however few threads there are, and
 * whoever else wants them. Who has to wait for long, as another one lost its processor, offers his
 * own.
 *
 * <p>A phase costs a worker one store that the others see, and a look at each of them if it has a
 * border part. A claim per part would cost more, as it waits until all that was written before has
 * left for memory.
 *
 * <p>Who does what when shows in no result. One thread adds and runs. Allocates only when there are
 * more phases or domains than ever before.
 */
public final class DomainPhases implements Workers.Task {
  /**
   * Progress of domains is kept that many ints apart: two cache lines, as they come in pairs. The
   * first ones stay unused, as everybody reads the array's length beside them.
   */
  private static final int APART = 32;

  /** Looks for work before a thread offers its processor to others: some 100 microseconds. */
  private static final int LOOKS_BEFORE_YIELD = 2_000;

  private Workers workers;
  private int domains = 1;

  /** The phases: what is done, and its number there. */
  private Phase[] phase = new Phase[64];

  private int[] number = new int[64];
  private int phases;

  /** Per domain: how many phases somebody does or has done. */
  private AtomicIntegerArray claimed = new AtomicIntegerArray(2 * APART);

  /** Per domain: how many are done. */
  private AtomicIntegerArray done = new AtomicIntegerArray(2 * APART);

  /** Whether a part threw. */
  private volatile boolean failed;

  /** What a phase does. */
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
     * Whether a border part does anything. Who has none needn't wait for the others.
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
   * Sets how many domains there are; phases that were added and not run are forgotten.
   *
   * @param count at least 1
   * @param parallel who does them; not looked at for one domain, which the caller does
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
   * Adds a phase, which is done by the next {@link #run} after all that were added before.
   *
   * @param what does it
   * @param given handed on to it
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
   * Does the phases of a domain, and helps where nobody else is, until nobody needs help. For
   * {@link #run()} alone.
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

  /** Does a phase of a domain whose worker hasn't come; answers whether there was one to do. */
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
      failed = true; // the part will never be done, and nobody is to wait for it
      throw e;
    }
  }

  /** Whether the others are as far as the border part of a phase needs them to be. */
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
