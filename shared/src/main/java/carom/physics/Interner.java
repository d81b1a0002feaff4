package carom.physics;

import carom.physics.archive.Archive;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiPredicate;
import java.util.function.UnaryOperator;

/**
 * Archive format of values that many owners share. Each value is written once: the first mention
 * has the contents, and later ones refer to it.
 *
 * @param <E> type of the values
 */
final class Interner<E> {
  /** Number of the newest values that a writer compares with. */
  private static final int LOOKED_THROUGH = 64;

  private final List<E> known = new ArrayList<>();
  private final BiPredicate<E, E> same;

  /**
   * Creates an empty interner.
   *
   * @param same returns true if two values have equal contents
   */
  public Interner(BiPredicate<E, E> same) {
    this.same = same;
  }

  /**
   * Passes one value through an archive.
   *
   * @param a the archive
   * @param what name of the value, for messages
   * @param one the value; null when reading
   * @param content passes the contents through the archive
   * @return the value, the same one for equal contents
   */
  public E pass(Archive a, String what, E one, UnaryOperator<E> content) {
    int place = a.integer(what, a.reads() ? 0 : find(one), 0, known.size());
    if (place == known.size()) {
      known.add(content.apply(one));
    }
    return known.get(place);
  }

  private int find(E one) {
    int first = Math.max(0, known.size() - LOOKED_THROUGH);
    for (int i = known.size() - 1; i >= first; i--) {
      if (known.get(i) == one) { // the most frequent case, and a fast one
        return i;
      }
    }
    for (int i = known.size() - 1; i >= first; i--) {
      if (same.test(known.get(i), one)) {
        return i;
      }
    }
    return known.size();
  }
}
