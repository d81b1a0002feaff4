package carom.physics.dynamics;

/**
 * Decides which rows of the contact table stay when new pairs are merged in: those that touch, and
 * those whose fat boxes overlap.
 */
final class StayingRows {
  /** Rows that make a piece of work for a worker. */
  private static final int GRAIN = 512;

  private final ContactTable table;

  /** Per row. */
  private boolean[] stays = new boolean[0];

  // What the decision is about.
  private ShapeTable parts;
  private boolean all;
  private final Crew.Range deciding = (from, to, worker) -> decide(from, to);

  /** Decides about the rows of this table. */
  StayingRows(ContactTable table) {
    this.table = table;
  }

  /**
   * Decides about each row.
   *
   * @param shapes have fat boxes, some of which {@link ShapeTable#moved}
   * @param every whether to look at all rows, or only at those of moved parts
   * @param crew does it
   * @return per row; until the next call
   */
  boolean[] find(ShapeTable shapes, boolean every, Crew crew) {
    if (stays.length < table.count()) {
      stays = new boolean[table.key.length];
    }
    parts = shapes;
    all = every;
    crew.run(0, table.count(), GRAIN, deciding);
    return stays;
  }

  private void decide(int from, int to) {
    for (int row = from; row < to; row++) {
      stays[row] = stays(row);
    }
  }

  private boolean stays(int row) {
    byte flags = table.flags[row];
    if ((flags & ContactTable.TOUCHING) != 0) {
      return true;
    }
    if ((flags & ContactTable.IGNORED) != 0) {
      return false;
    }
    int a = table.part[2 * row];
    int b = table.part[2 * row + 1];
    return !(all || parts.moved[a] || parts.moved[b]) || parts.fat.overlaps(a, b);
  }
}
