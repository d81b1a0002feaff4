package carom.lab.bench;

import carom.lab.measure.Scaling;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneRun;
import java.util.Arrays;

/**
 * Measures {@link Scaling} beside a world that several threads step. The meter steps one more world
 * on the calling thread alone, and one world per thread at the same time. Each does as many steps
 * as the measured world, in the same turns. One thread at a time.
 */
final class ScalingMeter implements AutoCloseable {
  /** Time for which helpers sleep between two looks for work while others have the turn, ms. */
  private static final int IDLE_MS = 1;

  private final SceneRun alone;
  private final SceneRun[] together;
  private final Thread[] helpers;

  /** Number of steps that each of the worlds stepped at the same time should reach. */
  private volatile int wanted;

  /** True while steps follow each other closely. Helpers spin then. */
  private volatile boolean busy;

  private volatile boolean closed;

  /** The number of steps done, by helper. */
  private final Progress[] done;

  private double[] aloneMs = new double[0];
  private double[] togetherMs = new double[0];
  private double[] speedUps = new double[0];
  private double[] ceilings = new double[0];
  private double[] shares = new double[0];

  /** A counter that only one thread writes. */
  private static final class Progress {
    private volatile int steps;
  }

  /**
   * Builds the worlds and starts the helpers.
   *
   * @param scene the measured scene
   * @param threads number of threads, at least 2
   * @param warm number of steps before the first slice
   */
  ScalingMeter(Scene scene, int threads, int warm) {
    alone = scene.start();
    together = new SceneRun[threads];
    Arrays.setAll(together, i -> scene.start());
    helpers = new Thread[threads - 1];
    done = new Progress[helpers.length];
    for (int i = 0; i < helpers.length; i++) {
      int helper = i;
      done[i] = new Progress();
      helpers[i] = new Thread(() -> help(helper), "bench-world-" + (i + 1));
      helpers[i].setDaemon(true);
      helpers[i].start();
    }
    step(warm);
  }

  private void help(int helper) {
    SceneRun world = together[helper + 1];
    int steps = 0;
    while (!closed) {
      if (steps < wanted) {
        world.step();
        steps++;
        done[helper].steps = steps;
      } else if (busy) {
        Thread.onSpinWait();
      } else {
        sleep(IDLE_MS);
      }
    }
  }

  private static void sleep(int milliseconds) {
    try {
      Thread.sleep(milliseconds);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Steps the worlds as far as the measured world.
   *
   * @param milliseconds clock time of each step of the measured world, ms
   */
  void slice(double[] milliseconds) {
    int steps = milliseconds.length;
    step(steps);
    double one = median(aloneMs);
    double all = median(togetherMs);
    double shared = median(milliseconds);
    speedUps = with(speedUps, one / shared);
    ceilings = with(ceilings, together.length * one / all);
    shares = with(shares, all / (together.length * shared));
  }

  private void step(int steps) {
    aloneMs = new double[steps];
    togetherMs = new double[steps];
    for (int i = 0; i < steps; i++) {
      long begin = System.nanoTime();
      alone.step();
      aloneMs[i] = (System.nanoTime() - begin) * 1e-6;
    }
    busy = true;
    sleep(2 * IDLE_MS); // until all helpers are awake
    for (int i = 0; i < steps; i++) {
      int target = wanted + 1;
      long begin = System.nanoTime();
      wanted = target;
      together[0].step();
      for (int h = 0; h < helpers.length; h++) {
        while (done[h].steps < target) {
          if (!helpers[h].isAlive()) {
            throw new IllegalStateException("a step failed on " + helpers[h].getName());
          }
          Thread.onSpinWait();
        }
      }
      togetherMs[i] = (System.nanoTime() - begin) * 1e-6;
    }
    busy = false;
  }

  private static double[] with(double[] values, double one) {
    double[] more = Arrays.copyOf(values, values.length + 1);
    more[values.length] = one;
    return more;
  }

  private static double median(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }

  /** Returns the medians over the slices, or {@link Scaling#NONE} if there was no slice. */
  Scaling result() {
    return shares.length == 0
        ? Scaling.NONE
        : new Scaling(median(speedUps), median(ceilings), median(shares));
  }

  /** Ends the helpers. */
  @Override
  public void close() {
    closed = true;
  }
}
