package carom.physics.broadphase;

import java.util.AbstractCollection;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.function.BiConsumer;

/**
 * A {@link Collection} of elements that have boxes: a spatial index without ids.
 *
 * <p>The collection is a bag in insertion order: it may hold equal elements twice. Call {@link
 * #rebuild()} after elements moved; adding and removing needs no call. Not thread-safe. {@code add}
 * is O(1), {@code remove} and {@code contains} are O(n); searches cost as much as those of the
 * index.
 *
 * @param <E> type of the elements
 */
public final class SpatialCollection<E> extends AbstractCollection<E> {
  private final SpatialIndex index;
  private final BoxWriter<? super E> writer;
  private final List<E> elements = new ArrayList<>();
  private final AabbArray boxes = new AabbArray(0);
  private int[] ids = new int[0];
  private int[] found = new int[16];
  private int foundCount;
  private boolean stale = true;

  /**
   * Makes an empty collection over a KD-tree.
   *
   * @param writer writes the boxes of elements
   */
  public SpatialCollection(BoxWriter<? super E> writer) {
    this(new KdTree(new AabbArray(0)), writer);
  }

  /**
   * Makes an empty collection.
   *
   * @param index the index to use; the collection owns it from now on and replaces its contents
   * @param writer writes the boxes of elements
   */
  public SpatialCollection(SpatialIndex index, BoxWriter<? super E> writer) {
    this.index = Objects.requireNonNull(index, "index");
    this.writer = Objects.requireNonNull(writer, "writer");
  }

  @Override
  public boolean add(E element) {
    elements.add(Objects.requireNonNull(element, "element"));
    stale = true;
    return true;
  }

  @Override
  public void clear() {
    elements.clear();
    stale = true;
  }

  @Override
  public int size() {
    return elements.size();
  }

  @Override
  public Iterator<E> iterator() {
    Iterator<E> iterator = elements.iterator();
    return new Iterator<>() {
      @Override
      public boolean hasNext() {
        return iterator.hasNext();
      }

      @Override
      public E next() {
        return iterator.next();
      }

      @Override
      public void remove() {
        iterator.remove();
        stale = true;
      }
    };
  }

  /**
   * Reads the box of every element again. A KD-tree is refitted if elements only moved.
   *
   * @throws IllegalArgumentException if a box isn't finite with min &lt;= max
   */
  public void rebuild() {
    boolean onlyMoved = !stale;
    stale = true;
    int count = elements.size();
    boxes.ensureCapacity(count);
    for (int id = 0; id < count; id++) {
      writer.write(elements.get(id), boxes, id);
    }
    if (onlyMoved && index instanceof KdTree tree) {
      tree.refit();
    } else {
      if (ids.length < count) {
        ids = new int[boxes.capacity()];
        Arrays.setAll(ids, id -> id);
      }
      index.rebuild(boxes, ids, count);
    }
    stale = false;
  }

  /**
   * Finds the elements whose boxes, as of the last rebuild, overlap the given one, and adds them to
   * a collection in insertion order.
   *
   * @param minX left edge, m
   * @param minY lower edge, m
   * @param maxX right edge, m
   * @param maxY upper edge, m
   * @param out receives the elements; not cleared
   */
  public void retrieve(float minX, float minY, float maxX, float maxY, Collection<? super E> out) {
    update();
    foundCount = 0;
    index.query(minX, minY, maxX, maxY, this::remember);
    Arrays.sort(found, 0, foundCount);
    for (int i = 0; i < foundCount; i++) {
      out.add(elements.get(found[i]));
    }
  }

  /**
   * Visits every pair of elements whose boxes, as of the last rebuild, overlap. The element added
   * first comes first in its pair. The order of the pairs is unspecified.
   *
   * @param visitor receives the pairs; must not change the collection
   */
  public void forEachPair(BiConsumer<? super E, ? super E> visitor) {
    update();
    index.pairs((a, b) -> visitor.accept(elements.get(a), elements.get(b)));
  }

  private boolean remember(int id) {
    if (foundCount == found.length) {
      found = Arrays.copyOf(found, 2 * foundCount);
    }
    found[foundCount++] = id;
    return true;
  }

  private void update() {
    if (stale) {
      rebuild();
    }
  }
}
