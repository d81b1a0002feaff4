package carom.physics.broadphase;

import java.util.Arrays;
import java.util.SplittableRandom;

/** A seeded world of boxes that move, come and go. */
public final class Boxes {
  /** How the boxes lie. */
  public enum Layout {
    UNIFORM,
    CLUSTERED,
    IDENTICAL,
    COLLINEAR,
    COLUMN,
    HUGE_AND_TINY,
    POINTS,
    GRID,
    NEGATIVE,
    FAR_AWAY,
    EXTREME
  }

  public final AabbArray array;
  final Layout layout;
  final long seed;
  private final SplittableRandom random;
  private final boolean[] present;
  private int[] ids;

  public Boxes(Layout layout, int capacity, long seed) {
    this.layout = layout;
    this.seed = seed;
    array = new AabbArray(capacity);
    present = new boolean[capacity];
    random = new SplittableRandom(seed);
    for (int id = 0; id < capacity; id++) {
      place(id);
      present[id] = true;
    }
  }

  @Override
  public String toString() {
    return "layout=" + layout + " n=" + array.capacity() + " seed=" + seed;
  }

  public float between(double low, double high) {
    return (float) (low + (high - low) * random.nextDouble());
  }

  public int below(int bound) {
    return random.nextInt(bound);
  }

  /** Gives a box a new place and size. */
  public void place(int id) {
    double side = 1.5 * Math.sqrt(array.capacity());
    switch (layout) {
      case UNIFORM -> at(id, between(0, side), between(0, side), 0.75);
      case CLUSTERED -> {
        double spread = id % 10 == 0 ? 10 * side : side / 10;
        at(id, between(0, spread), between(0, spread), 0.2);
      }
      case IDENTICAL -> array.set(id, 3, 4, 5, 6);
      case COLLINEAR -> at(id, between(0, array.capacity()), 7, 0.75);
      case COLUMN -> at(id, 7, id, 0.5);
      case HUGE_AND_TINY -> at(id, between(0, side), between(0, side), id % 50 == 0 ? 1e6 : 0.001);
      case POINTS -> {
        float x = below(10);
        float y = below(10);
        array.set(id, x, y, x, y);
      }
      case GRID -> {
        float x = id % 20 - 10;
        float y = id / 20 - 10;
        array.set(id, x == 0 ? -0f : x, y == 0 ? 0f : y, x + 1 == 0 ? -0f : x + 1, y + 1);
      }
      case NEGATIVE -> at(id, between(-side, 0), between(-side, 0), 0.75);
      case FAR_AWAY -> at(id, 1e7 + between(0, side), -1e7 + between(0, side), 0.75);
      case EXTREME -> at(id, between(-1e38, 1e38), between(-1e38, 1e38), 1e37);
    }
  }

  private void at(int id, double x, double y, double size) {
    double halfX = between(0, size);
    double halfY = between(0, size);
    array.set(
        id, (float) (x - halfX), (float) (y - halfY), (float) (x + halfX), (float) (y + halfY));
  }

  /** Shifts every box by up to this much. */
  public void drift(double reach) {
    for (int id = 0; id < array.capacity(); id++) {
      shift(id, between(-reach, reach), between(-reach, reach));
    }
  }

  public void shift(int id, float dx, float dy) {
    array.set(
        id, array.minX(id) + dx, array.minY(id) + dy, array.maxX(id) + dx, array.maxY(id) + dy);
  }

  public boolean isPresent(int id) {
    return present[id];
  }

  public void setPresent(int id, boolean there) {
    present[id] = there;
  }

  int capacity() {
    return array.capacity();
  }

  /** The ids that are present, ascending. */
  public int[] ids() {
    ids = new int[capacity()];
    int count = 0;
    for (int id = 0; id < capacity(); id++) {
      if (present[id]) {
        ids[count++] = id;
      }
    }
    ids = Arrays.copyOf(ids, count);
    return ids;
  }
}
