package carom.sim.pool;

import carom.physics.particles.Particles;
import java.util.Arrays;

/**
 * The effect of a pool on bodies after one tick: how full each cell of its rectangle is, and how
 * fast that moves. Between the middles of cells, the values are interpolated. One thread; allocates
 * nothing after its creation.
 */
final class PoolGrid {
  /** Width of a cell in spacings. */
  static final float SPACINGS = 2.5f;

  /** Speed, m/s, from which particles keep bodies near them awake. */
  private static final float FAST = 0.4f;

  /** The tick that the cells are of; -1 for none. */
  int tick = -1;

  // The box of particles that are fast; empty if minX > maxX.
  float minX;
  float minY;
  float maxX;
  float maxY;

  private final float left;
  private final float low;
  private final float perCell;
  private final int columns;
  private final int rows;
  private final float share;
  private final float[] fill;
  private final float[] flowX;
  private final float[] flowY;

  // The result of read.
  float full;
  float momentumX;
  float momentumY;

  PoolGrid(PoolDef def) {
    left = def.box().minX();
    low = def.box().minY();
    columns = columns(def);
    rows = rows(def);
    perCell = 1 / (SPACINGS * def.spacing());
    share = 1 / (SPACINGS * SPACINGS);
    fill = new float[columns * rows];
    flowX = new float[fill.length];
    flowY = new float[fill.length];
    forget();
  }

  static int columns(PoolDef def) {
    return 1 + (int) ((def.box().maxX() - def.box().minX()) / (SPACINGS * def.spacing()));
  }

  static int rows(PoolDef def) {
    return 1 + (int) ((def.box().maxY() - def.box().minY()) / (SPACINGS * def.spacing()));
  }

  private void forget() {
    minX = Float.POSITIVE_INFINITY;
    minY = Float.POSITIVE_INFINITY;
    maxX = Float.NEGATIVE_INFINITY;
    maxY = Float.NEGATIVE_INFINITY;
  }

  /** Takes over the cells of another tick of the same pool. */
  void copy(PoolGrid from) {
    System.arraycopy(from.fill, 0, fill, 0, fill.length);
    System.arraycopy(from.flowX, 0, flowX, 0, fill.length);
    System.arraycopy(from.flowY, 0, flowY, 0, fill.length);
    minX = from.minX;
    minY = from.minY;
    maxX = from.maxX;
    maxY = from.maxY;
  }

  /**
   * Measures the particles: each spreads over the four cells whose middles are around it. A cell
   * holds at most what it has room for.
   *
   * @return the sum of the particles' squared speeds
   */
  double measure(Particles particles) {
    Arrays.fill(fill, 0);
    Arrays.fill(flowX, 0);
    Arrays.fill(flowY, 0);
    forget();
    double sum = 0;
    int n = particles.count();
    for (int i = 0; i < n; i++) {
      float x = particles.x(i);
      float y = particles.y(i);
      float vx = particles.velocityX(i);
      float vy = particles.velocityY(i);
      add(x, y, vx, vy);
      float squared = vx * vx + vy * vy;
      sum += squared;
      if (squared > FAST * FAST) {
        minX = Math.min(minX, x);
        minY = Math.min(minY, y);
        maxX = Math.max(maxX, x);
        maxY = Math.max(maxY, y);
      }
    }
    for (int i = 0; i < fill.length; i++) {
      if (fill[i] > 1) {
        flowX[i] /= fill[i];
        flowY[i] /= fill[i];
        fill[i] = 1;
      }
    }
    return sum;
  }

  private void add(float x, float y, float vx, float vy) {
    float gx = (x - left) * perCell - 0.5f;
    float gy = (y - low) * perCell - 0.5f;
    int column = Math.max(0, Math.min(columns - 2, (int) gx));
    int row = Math.max(0, Math.min(rows - 2, (int) gy));
    float toRight = Math.max(0, Math.min(1, gx - column));
    float up = Math.max(0, Math.min(1, gy - row));
    add(column, row, share * (1 - toRight) * (1 - up), vx, vy);
    add(column + 1, row, share * toRight * (1 - up), vx, vy);
    add(column, row + 1, share * (1 - toRight) * up, vx, vy);
    add(column + 1, row + 1, share * toRight * up, vx, vy);
  }

  private void add(int column, int row, float weight, float vx, float vy) {
    if (column >= 0 && row >= 0 && column < columns && row < rows) {
      int i = row * columns + column;
      fill[i] += weight;
      flowX[i] += weight * vx;
      flowY[i] += weight * vy;
    }
  }

  /**
   * Reads a point: {@link #full} is 0..1, the momenta are that times the velocity, m/s.
   *
   * @return whether anything is there
   */
  boolean read(float x, float y) {
    float gx = (x - left) * perCell - 0.5f;
    float gy = (y - low) * perCell - 0.5f;
    if (!(gx > -1 && gy > -1 && gx < columns && gy < rows)) {
      full = 0;
      return false;
    }
    int column = Math.max(0, Math.min(columns - 2, (int) gx));
    int row = Math.max(0, Math.min(rows - 2, (int) gy));
    float toRight = Math.max(0, Math.min(1, gx - column));
    float up = Math.max(0, Math.min(1, gy - row));
    full = 0;
    momentumX = 0;
    momentumY = 0;
    read(column, row, (1 - toRight) * (1 - up));
    read(column + 1, row, toRight * (1 - up));
    read(column, row + 1, (1 - toRight) * up);
    read(column + 1, row + 1, toRight * up);
    return full > 0;
  }

  private void read(int column, int row, float weight) {
    if (column >= 0 && row >= 0 && column < columns && row < rows) {
      int i = row * columns + column;
      full += weight * fill[i];
      momentumX += weight * flowX[i];
      momentumY += weight * flowY[i];
    }
  }
}
