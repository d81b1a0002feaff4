package carom.physics;

import carom.physics.archive.Archive;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiPredicate;
import java.util.function.UnaryOperator;

/**
 * Things that many bodies have in common, in an archive once: the first mention says what it is,
 * later ones refer to it.
 */
final class Interner<E> {
  /** How many of the last new ones are looked through when writing. */
  private static final int LOOKED_THROUGH = 64;

  private final List<E> known = new ArrayList<>();
  private final BiPredicate<E, E> same;

  Interner(BiPredicate<E, E> same) {
    this.same = same;
  }

  /** Passes one through an archive; {@code content} passes what it is. */
  E pass(Archive a, String what, E one, UnaryOperator<E> content) {
    int place = a.integer(what, a.reads() ? 0 : find(one), 0, known.size());
    if (place == known.size()) {
      known.add(content.apply(one));
    }
    return known.get(place);
  }

  private int find(E one) {
    int first = Math.max(0, known.size() - LOOKED_THROUGH);
    for (int i = known.size() - 1; i >= first; i--) {
      if (known.get(i) == one) { // mostly, and found in a fraction of the time
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
