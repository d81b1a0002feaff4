package carom.physics.rows;

import java.util.Arrays;

/**
 * Counts the rows of each kind in a sequence that is ordered by kind, and so tells which kind a row
 * is of. Mutable, reused; one thread.
 */
public final class RowCounts {
  private static final RowKind[] KINDS = RowKind.values();

  private final int[] counts = new int[KINDS.length];

  /** Creates the counts of an empty sequence. */
  public RowCounts() {}

  /** Removes all rows. */
  public void clear() {
    Arrays.fill(counts, 0);
  }

  /** Returns the number of rows of a kind. */
  public int get(RowKind kind) {
    return counts[kind.ordinal()];
  }

  /** Sets the number of rows of a kind. */
  public void set(RowKind kind, int count) {
    counts[kind.ordinal()] = count;
  }

  /** Takes over other counts. */
  public void set(RowCounts other) {
    System.arraycopy(other.counts, 0, counts, 0, counts.length);
  }

  /** Returns the number of all rows. */
  public int total() {
    int total = 0;
    for (int count : counts) {
      total += count;
    }
    return total;
  }

  /** Returns the number of the first row of a kind, or where it would be. */
  public int first(RowKind kind) {
    int first = 0;
    for (int i = 0; i < kind.ordinal(); i++) {
      first += counts[i];
    }
    return first;
  }

  /** Returns the kind of a row; rows beyond the last are of the last kind. */
  public RowKind kind(int row) {
    int first = 0;
    for (int i = 0; i < counts.length - 1; i++) {
      first += counts[i];
      if (row < first) {
        return KINDS[i];
      }
    }
    return KINDS[KINDS.length - 1];
  }
}
