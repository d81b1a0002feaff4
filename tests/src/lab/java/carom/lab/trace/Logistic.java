package carom.lab.trace;

/**
 * The logistic function and its inverse on integers: probabilities in 1/65,536, log odds in 1/256.
 * Tables made with {@link StrictMath}, so that they are the same everywhere.
 */
final class Logistic {

  /** Largest log odds. Beyond it a probability can't be told from 0 or 1. */
  static final int MAX = 2_815;

  private static final char[] SQUASH = new char[2 * MAX + 1];
  private static final short[] STRETCH = new short[4_096];

  static {
    for (int i = -MAX; i <= MAX; i++) {
      double p = 65_536 / (1 + StrictMath.exp(-i / 256.0));
      SQUASH[i + MAX] = (char) Math.max(1, Math.min(65_535, StrictMath.round(p)));
    }
    for (int i = 0; i < STRETCH.length; i++) {
      double p = (i + 0.5) / STRETCH.length;
      STRETCH[i] = (short) StrictMath.round(256 * StrictMath.log(p / (1 - p)));
    }
  }

  private Logistic() {}

  /** Returns the probability, 1..65,535, of any log odds. */
  static int squash(int odds) {
    return SQUASH[Math.max(-MAX, Math.min(MAX, odds)) + MAX];
  }

  /** Returns the log odds of a probability in 1/4,096. */
  static int stretch(int probability12) {
    return STRETCH[probability12];
  }
}
