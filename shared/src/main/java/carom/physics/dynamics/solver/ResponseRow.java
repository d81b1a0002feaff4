package carom.physics.dynamics.solver;

/**
 * A direction in which a contact acts on two bodies, and what impulses along it do to both. A body
 * is an array: vx, vy, w, then its response to impulses (x, y, turn) as xx, xy, xw, yy, yw, ww.
 */
final class ResponseRow {
  private final double[] a;
  private final double[] b;

  /** The direction; zero for a row that only turns. */
  public double x;

  /** The direction's y. */
  public double y;

  /** Lever arm of A, m; 1 for a row that only turns. */
  public double armA;

  /** Lever arm of B. */
  public double armB;

  /** The sum of this visit's impulses. */
  public double sum;

  // Changes of velocity of A and B by an impulse of 1 N s on each.

  private double ax;
  private double ay;
  private double aw;
  private double bx;
  private double by;
  private double bw;

  /** Makes rows of these bodies. */
  public ResponseRow(double[] a, double[] b) {
    this.a = a;
    this.b = b;
  }

  /** Points the row along (ux, uy) with the lever arms of A and B; nothing is summed up. */
  public void set(double ux, double uy, double ofA, double ofB) {
    x = ux;
    y = uy;
    armA = ofA;
    armB = ofB;
    ax = a[3] * ux + a[4] * uy + a[5] * ofA;
    ay = a[4] * ux + a[6] * uy + a[7] * ofA;
    aw = a[5] * ux + a[7] * uy + a[8] * ofA;
    bx = b[3] * ux + b[4] * uy + b[5] * ofB;
    by = b[4] * ux + b[6] * uy + b[7] * ofB;
    bw = b[5] * ux + b[7] * uy + b[8] * ofB;
    sum = 0;
  }

  /** Returns the speed at which B parts from A in this direction. */
  public double speed() {
    return x * (b[0] - a[0]) + y * (b[1] - a[1]) + armB * b[2] - armA * a[2];
  }

  /** Returns what an impulse along another row does to this row's speed. */
  public double by(ResponseRow o) {
    return x * (o.ax + o.bx) + y * (o.ay + o.by) + armA * o.aw + armB * o.bw;
  }

  /** Applies an impulse to B, and its opposite to A. */
  public void apply(double p) {
    sum += p;
    a[0] -= p * ax;
    a[1] -= p * ay;
    a[2] -= p * aw;
    b[0] += p * bx;
    b[1] += p * by;
    b[2] += p * bw;
  }
}
