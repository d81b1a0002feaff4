package carom.physics.broadphase;

import java.util.Arrays;

/**
 * An index that tests every box against every other: the oracle of the tests. A query is O(n), all
 * pairs are O(n^2). It is obviously right, and the fastest choice below a dozen boxes.
 */
public final class BruteForce implements SpatialIndex {
  private int[] ids = new int[0];
  private int size;
  private final AabbArray copy = new AabbArray(0);
  private final MovingBox moving = new MovingBox();

  /** Makes an empty index. */
  public BruteForce() {
    // empty until the first rebuild
  }

  @Override
  public void rebuild(AabbArray boxes, int[] newIds, int count) {
    if (count < 0 || count > newIds.length) {
      throw new IllegalArgumentException("count=" + count + ", limit 0.." + newIds.length);
    }
    size = 0;
    if (ids.length < count) {
      ids = Arrays.copyOf(ids, Math.max(count, ids.length + (ids.length >> 1)));
    }
    copy.ensureCapacity(count);
    for (int i = 0; i < count; i++) {
      int id = newIds[i];
      boxes.check(id);
      ids[i] = id;
      copy.set(i, boxes.minX(id), boxes.minY(id), boxes.maxX(id), boxes.maxY(id));
    }
    size = count;
  }

  @Override
  public void query(float minX, float minY, float maxX, float maxY, IntVisitor visitor) {
    for (int i = 0; i < size; i++) {
      if (copy.overlaps(i, minX, minY, maxX, maxY) && !visitor.visit(ids[i])) {
        return;
      }
    }
  }

  @Override
  public void cast(
      float minX,
      float minY,
      float maxX,
      float maxY,
      float dx,
      float dy,
      float maxFraction,
      CastVisitor visitor) {
    moving.set(minX, minY, maxX, maxY, dx, dy);
    float end = maxFraction;
    for (int i = 0; i < size && end >= 0; i++) {
      if (moving.enter(copy, i) <= end) {
        end = visitor.visit(ids[i], end);
      }
    }
  }

  @Override
  public void pairs(PairVisitor visitor) {
    for (int i = 0; i < size; i++) {
      for (int j = i + 1; j < size; j++) {
        if (copy.overlaps(i, j)) {
          visitor.pair(Math.min(ids[i], ids[j]), Math.max(ids[i], ids[j]));
        }
      }
    }
  }

  @Override
  public int size() {
    return size;
  }
}
