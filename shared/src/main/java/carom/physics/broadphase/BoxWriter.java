package carom.physics.broadphase;

/**
 * Writes the boxes of elements for a {@link SpatialCollection}.
 *
 * @param <E> type of the elements
 */
@FunctionalInterface
public interface BoxWriter<E> {
  /**
   * Writes the box of an element, e.g. {@code boxes.set(id, minX, minY, maxX, maxY)}.
   *
   * @param element the element whose box to write
   * @param boxes receives the box; don't keep a reference
   * @param id index at which to write the box
   */
  void write(E element, AabbArray boxes, int id);
}
