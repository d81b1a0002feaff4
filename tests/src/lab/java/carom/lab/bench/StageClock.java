package carom.lab.bench;

import carom.physics.profile.StageListener;
import carom.physics.profile.StepStage;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;

/**
 * Times the stages of steps by the clock. It costs about 30 ns per stage and allocates nothing
 * while it listens.
 */
final class StageClock implements StageListener {
  private static final StepStage[] STAGES = StepStage.values();

  /** The times by stage and step, ns. */
  private final double[][] spent;

  private int step;
  private StepStage current;
  private long since;

  /** Creates a clock for a number of steps. It ignores later steps. */
  StageClock(int steps) {
    spent = new double[STAGES.length][steps];
  }

  @Override
  public void begins(StepStage stage) {
    lap();
    current = stage;
  }

  @Override
  public void done() {
    lap();
    current = null;
    step++;
  }

  private void lap() {
    long now = System.nanoTime();
    if (current != null && step < spent[0].length) {
      spent[current.ordinal()][step] += now - since;
    }
    since = now;
  }

  /**
   * Returns what each stage takes, in the order of the stages: the median over the steps, ms.
   * Stages that take no time worth telling (less than a microsecond) are left out.
   */
  Map<StepStage, Double> medianMs() {
    Map<StepStage, Double> medians = new EnumMap<>(StepStage.class);
    int steps = Math.min(step, spent[0].length);
    for (StepStage stage : STAGES) {
      double[] sorted = Arrays.copyOf(spent[stage.ordinal()], steps);
      Arrays.sort(sorted);
      if (steps > 0 && sorted[steps / 2] >= 1000) {
        medians.put(stage, sorted[steps / 2] * 1e-6);
      }
    }
    return medians;
  }
}
