package carom.physics.threads;

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
 * <p>A worker does the parts of its own domain, and those of domains whose worker hasn't come, or
 * seems to have lost its processor between two parts. So all is done however few threads there are,
 * and whoever else wants them. Who has to wait for long, as another one lost its processor in the
 * midst of a part, offers his own.
 *
 * <p>Who does what when shows in no result. One thread adds and runs. Allocates only when there are
 * more phases or domains than ever before.
 */
public final class Lockstep implements Workers.Task {
  /**
   * Progress of domains is kept that many ints apart: two cache lines, as they come in pairs. The
   * first ones stay unused, as everybody reads the array's length beside them.
   */
  private static final int APART = 32;

  /** Looks at a domain that could go on but doesn't before another thread helps it. */
  private static final int LOOKS_BEFORE_HELP = 200;

  /** Looks for work before a thread offers its processor to others: some 100 microseconds. */
  private static final int LOOKS_BEFORE_YIELD = 2_000;

  private Workers workers;
  private int domains = 1;

  /** The phases: what is done, and its number there. */
  private Phase[] phase = new Phase[64];

  private int[] number = new int[64];
  private int phases;

  /** Per domain: twice the parts that are done, plus one while somebody does the next one. */
  private AtomicIntegerArray done = new AtomicIntegerArray(2 * APART);

  /** Whether a part threw. */
  private volatile boolean failed;

  /** Per domain: 1 while the thread that its task was given to is at work. */
  private AtomicIntegerArray attended = new AtomicIntegerArray(2 * APART);

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
  }

  /**
   * Sets how many domains there are; phases that were added and not run are forgotten.
   *
   * @param count at least 1
   * @param crew who does them; not looked at for one domain, which the caller does
   */
  public void divide(int count, Workers crew) {
    domains = count;
    workers = crew;
    phases = 0;
    if (done.length() < (count + 1) * APART) {
      done = new AtomicIntegerArray((count + 1) * APART);
      attended = new AtomicIntegerArray((count + 1) * APART);
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
        attended.setPlain(place(domain), 0);
      }
      failed = false;
      workers.run(domains, this);
    }
    phases = 0;
  }

  /**
   * Does the parts of a domain, and helps where need is, until nothing is left to do. For {@link
   * #run()} alone.
   */
  @Override
  public void run(int own, int worker) {
    attended.setOpaque(place(own), 1);
    int looks = 0;
    while (true) {
      boolean helps = looks > LOOKS_BEFORE_HELP;
      boolean any = advance(own, worker);
      boolean left = false;
      for (int k = 1; k < domains && !any; k++) {
        int other = own + k < domains ? own + k : own + k - domains;
        if (helps || attended.getOpaque(place(other)) == 0) {
          any = advance(other, worker);
        }
      }
      for (int domain = 0; domain < domains && !any; domain++) {
        left |= done.get(place(domain)) < 4 * phases;
      }
      if (any) {
        looks = 0;
      } else if (!left || failed) {
        attended.setOpaque(place(own), 0);
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

  /** Does the next parts of a domain as long as nothing hinders; answers whether it did any. */
  private boolean advance(int domain, int worker) {
    boolean any = false;
    int at = place(domain);
    int progress = done.get(at);
    while (progress < 4 * phases
        && (progress & 1) == 0
        && mayDo(progress >> 1, domain)
        && done.compareAndSet(at, progress, progress + 1)) {
      int i = progress >> 2;
      try {
        phase[i].run(number[i], domain, (progress & 2) != 0, worker);
      } catch (RuntimeException | Error e) {
        failed = true; // the part will never be done, and nobody is to wait for it
        throw e;
      }
      progress += 2;
      done.setRelease(at, progress);
      any = true;
    }
    return any;
  }

  private static int place(int domain) {
    return (domain + 1) * APART;
  }

  /** Whether the others are as far as a part of a domain needs them to be. */
  private boolean mayDo(int part, int domain) {
    if ((part & 1) == 0) {
      return true;
    }
    int least = 2 * (part - 1);
    for (int other = 0; other < domains; other++) {
      if (other != domain && done.getAcquire(place(other)) < least) {
        return false;
      }
    }
    return true;
  }
}
