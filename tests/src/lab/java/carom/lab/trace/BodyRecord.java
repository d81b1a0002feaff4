package carom.lab.trace;

import java.util.Arrays;

/** What the snapshots up to one of them have shown of each body. */
final class BodyRecord {

  /** For how many snapshots it has not changed. */
  final int[] still;

  /** For how many snapshots it has moved as smoothly as rounding allows. */
  final int[] sinceJolt;

  /** Mean second difference, in 1/16 steps. */
  final int[][] trend;

  /** Mean magnitude of its last residuals, in 1/16 steps. */
  final int[][] error;

  /** The same over a longer time, in 1/256 steps. */
  final int[][] slowError;

  /** Its last residual, in steps. */
  final int[][] lastResidual;

  /** Whether it was the same as in the baseline: a bit for each snapshot, the newest lowest. */
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
