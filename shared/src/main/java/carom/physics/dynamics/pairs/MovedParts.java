package carom.physics.dynamics.pairs;

import carom.physics.dynamics.body.ShapeTable;
import java.util.Arrays;

/**
 * The parts whose fat box changed since pairs were last searched: only pairs with one of them can
 * be new. The flags are in {@link ShapeTable#moved} and {@link ShapeTable#together}; this list
 * allows to clear them again without looking at every part.
 */
final class MovedParts {
  /** The parts, the first {@link #count} entries. */
  int[] list = new int[64];

  int count;

  /** Number of those that moved together with their neighbours. */
  int togetherCount;

  private final ShapeTable parts;

  MovedParts(ShapeTable parts) {
    this.parts = parts;
  }

  /** Marks a part. Does nothing if it is marked already. */
  void mark(int part) {
    if (parts.moved[part]) {
      return;
    }
    parts.moved[part] = true;
    if (count == list.length) {
      list = Arrays.copyOf(list, Math.max(parts.moved.length, count * 2));
    }
    list[count++] = part;
  }

  /** Marks a part as one of a group of neighbours, which a walk of the tree finds at once. */
  void markTogether(int part) {
    mark(part);
    togetherCount += parts.together[part] ? 0 : 1;
    parts.together[part] = true;
  }

  /** Clears the marks of all listed parts, after their pairs were searched. */
  void clear() {
    for (int i = 0; i < count; i++) {
      parts.moved[list[i]] = false;
      parts.together[list[i]] = false;
    }
    drop();
  }

  /** Empties the list without touching the flags, for a table of parts that was replaced. */
  void drop() {
    count = 0;
    togetherCount = 0;
  }
}
