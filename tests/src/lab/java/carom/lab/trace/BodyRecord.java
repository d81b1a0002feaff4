package carom.lab.trace;

import java.util.Arrays;

/** The features of each body that follow from the snapshots up to one of them. */
final class BodyRecord {

  /** Number of snapshots for which the body has not changed. */
  final int[] still;

  /** Number of snapshots for which the body has moved as smoothly as rounding allows. */
  final int[] sinceJolt;

  /** Mean second difference, in 1/16 steps. */
  final int[][] trend;

  /** Mean magnitude of the last residuals, in 1/16 steps. */
  final int[][] error;

  /** Mean magnitude of the residuals over a longer time, in 1/256 steps. */
  final int[][] slowError;

  /** The last residual, in steps. */
  final int[][] lastResidual;

  /** Bits that tell whether the body equalled the baseline, one per snapshot, the newest lowest. */
  final int[] sameBefore;

  BodyRecord(int bodies, int fields, int atRest) {
    still = new int[bodies];
    Arrays.fill(still, atRest);
    sinceJolt = new int[bodies];
    trend = new int[fields][bodies];
    error = new int[fields][bodies];
    slowError = new int[fields][bodies];
    lastResidual = new int[fields][bodies];
    sameBefore = new int[bodies];
  }

  void set(BodyRecord other) {
    copy(other.still, still);
    copy(other.sinceJolt, sinceJolt);
    copy(other.sameBefore, sameBefore);
    for (int f = 0; f < trend.length; f++) {
      copy(other.trend[f], trend[f]);
      copy(other.error[f], error[f]);
      copy(other.slowError[f], slowError[f]);
      copy(other.lastResidual[f], lastResidual[f]);
    }
  }

  private static void copy(int[] from, int[] to) {
    System.arraycopy(from, 0, to, 0, from.length);
  }
}
