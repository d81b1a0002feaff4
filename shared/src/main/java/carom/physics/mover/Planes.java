package carom.physics.mover;

/**
 * Finds the motion nearest to a wanted one that keeps to one side of every plane of a small set:
 * the nearest {@code d} to {@code w} with {@code n_i . d >= o_i} for all i.
 *
 * <p>In two dimensions the answer is exact: it is the wanted motion, its projection on one plane,
 * or the corner of two planes. So a wedge gives a point, where clipping by one plane after the
 * other goes to and fro. Where no motion keeps to all planes, those that can't be kept are violated
 * as little as possible, by least squares, and the answer is the nearest that violates none
 * further. Nothing allocates.
 */
final class Planes {
  private static final int MAX = 24;
  private static final double TOLERANCE = 1e-9;
  private static final int ROUNDS = 12;

  private final double[] nx = new double[MAX];
  private final double[] ny = new double[MAX];
  private final double[] offset = new double[MAX];
  private int count;

  /** X of the answer. */
  double x;

  /** Y of the answer. */
  double y;

  /** Distance of the answer from the allowed side of a plane, m; 0 if all planes are kept. */
  double violation;

  private double bestSquare;

  void clear() {
    count = 0;
  }

  /**
   * Adds a plane. If there are too many, the one that asks for least is left out.
   *
   * @param normalX x of the unit normal, to the side where the motion may go
   * @param normalY y of the unit normal
   * @param least smallest component of the motion along the normal
   */
  void add(double normalX, double normalY, double least) {
    int at = count;
    if (count == MAX) {
      at = 0;
      for (int i = 1; i < MAX; i++) {
        at = offset[i] < offset[at] ? i : at;
      }
      if (least <= offset[at]) {
        return;
      }
    } else {
      count++;
    }
    nx[at] = normalX;
    ny[at] = normalY;
    offset[at] = least;
  }

  /** Sets {@link #x} and {@link #y} to the answer for a wanted motion. */
  void solve(double wantedX, double wantedY) {
    violation = 0;
    if (!nearest(wantedX, wantedY)) {
      relax();
      nearest(wantedX, wantedY);
    }
  }

  private boolean nearest(double wx, double wy) {
    bestSquare = Double.POSITIVE_INFINITY;
    offer(wx, wy, wx, wy);
    for (int i = 0; i < count && bestSquare > 0; i++) {
      double lacks = offset[i] - (nx[i] * wx + ny[i] * wy);
      if (lacks > 0) {
        offer(wx + lacks * nx[i], wy + lacks * ny[i], wx, wy);
        for (int j = 0; j < count; j++) {
          double det = nx[i] * ny[j] - ny[i] * nx[j];
          if (Math.abs(det) > 1e-6) {
            offer(
                (offset[i] * ny[j] - offset[j] * ny[i]) / det,
                (offset[j] * nx[i] - offset[i] * nx[j]) / det,
                wx,
                wy);
          }
        }
      }
    }
    return bestSquare < Double.POSITIVE_INFINITY;
  }

  /** Takes a motion as the answer if it keeps all planes and is nearer than the best so far. */
  private void offer(double dx, double dy, double wx, double wy) {
    double square = (dx - wx) * (dx - wx) + (dy - wy) * (dy - wy);
    if (!(square < bestSquare)) {
      return;
    }
    double slack = TOLERANCE * (1 + Math.abs(dx) + Math.abs(dy));
    for (int i = 0; i < count; i++) {
      if (nx[i] * dx + ny[i] * dy < offset[i] - slack) {
        return;
      }
    }
    bestSquare = square;
    x = dx;
    y = dy;
  }

  /** Lowers the planes that can't all be kept to what the least squares of violations reach. */
  private void relax() {
    double dx = 0;
    double dy = 0;
    for (int round = 0; round < ROUNDS; round++) {
      double xx = 1e-9;
      double xy = 0;
      double yy = 1e-9;
      double bx = 0;
      double by = 0;
      for (int i = 0; i < count; i++) {
        double lacks = offset[i] - (nx[i] * dx + ny[i] * dy);
        if (lacks > 0) {
          xx += nx[i] * nx[i];
          xy += nx[i] * ny[i];
          yy += ny[i] * ny[i];
          bx += nx[i] * lacks;
          by += ny[i] * lacks;
        }
      }
      double det = xx * yy - xy * xy;
      dx += (bx * yy - by * xy) / det;
      dy += (by * xx - bx * xy) / det;
    }
    for (int i = 0; i < count; i++) {
      double reached = nx[i] * dx + ny[i] * dy;
      violation = Math.max(violation, offset[i] - reached);
      offset[i] = Math.min(offset[i], reached);
    }
  }
}
