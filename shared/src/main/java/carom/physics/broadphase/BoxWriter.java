package carom.physics.broadphase;

import carom.physics.broadphase.index.AabbArray;

/**
 * Knows where elements are, for a {@link SpatialCollection}.
 *
 * @param <E> type of the elements
 */
@FunctionalInterface
public interface BoxWriter<E> {
  /**
   * Writes the box of an element, e.g. {@code boxes.set(id, minX, minY, maxX, maxY)}.
   *
   * @param element whose box
   * @param boxes where to write it; don't keep
   * @param id at which index
   */
  void write(E element, AabbArray boxes, int id);
}
