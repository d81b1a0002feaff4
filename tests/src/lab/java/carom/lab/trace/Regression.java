package carom.lab.trace;

/**
 * A linear prediction that fits itself to past samples: weighted least squares that slowly forget
 * (ridge regression by Cholesky's decomposition). With few samples it stays near a first guess. It
 * uses only the four operations and the square root on doubles, so results are the same on every
 * machine. One thread, no allocation.
 */
final class Regression {

  /** The factor by which past samples count less after each {@link #solve}. */
  private static final double KEEP = 0.95;

  /** Weight of the first guess, in samples of unit size. */
  private static final double HOLD = 20;

  private final int inputs;
  private final double[] guess;
  private final double[] weight;
  private final double[] xx;
  private final double[] xy;
  private final double[] factor;
  private boolean learnt;

  /**
   * Creates a regression that predicts one input as it is, until it knows better.
   *
   * @param inputs how many
   * @param guessed the input that is taken for the answer at first, or -1 for the answer zero
   */
  Regression(int inputs, int guessed) {
    this.inputs = inputs;
    guess = new double[inputs];
    if (guessed >= 0) {
      guess[guessed] = 1;
    }
    weight = guess.clone();
    xx = new double[inputs * inputs];
    xy = new double[inputs];
    factor = new double[inputs * inputs];
  }

  /** Returns the predicted answer. */
  double predict(double[] x) {
    double sum = 0;
    for (int i = 0; i < inputs; i++) {
      sum += weight[i] * x[i];
    }
    return sum;
  }

  /** Adds a sample. Its weight should be 1 over the square of the expected error. */
  void learn(double[] x, double answer, double importance) {
    learnt = true;
    for (int i = 0; i < inputs; i++) {
      double xi = x[i] * importance;
      if (xi != 0) {
        xy[i] += xi * answer;
        int row = i * inputs;
        for (int j = 0; j <= i; j++) {
          xx[row + j] += xi * x[j];
        }
      }
    }
  }

  /** Fits the weights to all samples so far, and lowers their weight a little. */
  void solve() {
    if (!learnt) {
      return;
    }
    for (int i = 0; i < inputs; i++) {
      int row = i * inputs;
      for (int j = 0; j <= i; j++) {
        double s = xx[row + j] + (i == j ? HOLD : 0);
        for (int k = 0; k < j; k++) {
          s -= factor[row + k] * factor[j * inputs + k];
        }
        factor[row + j] = i == j ? Math.sqrt(Math.max(s, HOLD / 1_000)) : s / at(j, j);
      }
    }
    for (int i = 0; i < inputs; i++) {
      double s = xy[i] + HOLD * guess[i];
      for (int k = 0; k < i; k++) {
        s -= at(i, k) * weight[k];
      }
      weight[i] = s / at(i, i);
    }
    for (int i = inputs - 1; i >= 0; i--) {
      double s = weight[i];
      for (int k = i + 1; k < inputs; k++) {
        s -= at(k, i) * weight[k];
      }
      weight[i] = s / at(i, i);
    }
    for (int i = 0; i < xx.length; i++) {
      xx[i] *= KEEP;
    }
    for (int i = 0; i < inputs; i++) {
      xy[i] *= KEEP;
    }
  }

  private double at(int row, int column) {
    return factor[row * inputs + column];
  }
}
