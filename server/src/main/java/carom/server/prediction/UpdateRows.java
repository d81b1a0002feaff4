package carom.server.prediction;

import carom.net.snapshot.exact.NearState;
import carom.net.snapshot.exact.UpdateDelivery;
import carom.physics.rows.ContactRow;
import carom.physics.rows.FieldRow;
import carom.physics.rows.JointRow;
import carom.physics.rows.RowCounts;
import carom.physics.rows.RowKind;
import carom.physics.rows.Rows;
import carom.sim.SimulationHost;
import carom.sim.near.Neighbourhood;
import java.util.Arrays;

/**
 * The content of an exact update: the state of the predicted set at one tick, the base, and which
 * of it is told. Told entities come first, in the order of the list, then the contacts of which at
 * least one end is told, then the fields of told entities.
 *
 * <p>The room's thread; allocates only to grow.
 */
final class UpdateRows implements UpdateDelivery.Content {
  private final Neighbourhood base;

  /** By place in the list: whether the entity is told. */
  private boolean[] isTold = new boolean[16];

  /** By place in the list: whether the entity is in the island of a newcomer that is awake. */
  private boolean[] inNewIsland = new boolean[16];

  private int[] told = new int[16];
  private int toldCount;

  /** By row of the update behind those of bodies: its row among the base's rows of its kind. */
  private int[] others = new int[16];

  private final RowCounts counts = new RowCounts();

  /**
   * Creates an empty update.
   *
   * @param viewer id of the player whose client predicts
   */
  UpdateRows(int viewer) {
    base = new Neighbourhood(viewer);
  }

  /** Reads the base, of which nothing is told yet. */
  void begin(EntityList entities, SimulationHost simulation) {
    base.clear();
    for (int i = 0; i < entities.count(); i++) {
      base.add(entities.get(i));
    }
    base.read(simulation);
    toldCount = 0;
    counts.clear();
    if (isTold.length < base.count()) {
      int room = Math.max(2 * isTold.length, base.count());
      isTold = new boolean[room];
      inNewIsland = new boolean[room];
      told = new int[room];
    }
    Arrays.fill(isTold, 0, base.count(), false);
    Arrays.fill(inNewIsland, 0, base.count(), false);
  }

  /** Tells the entity at a place in the list. */
  void tell(int place) {
    isTold[place] = true;
  }

  /** Tells the island of the entity at a place in the list, too; see {@link #end}. */
  void tellIsland(int place) {
    inNewIsland[place] = true;
  }

  /**
   * Completes the rows.
   *
   * <p>A body that entered the predicted set by contact, awake, has already moved its island in
   * this tick. The client didn't know the newcomer and predicted the island without it, so all of
   * the island is told.
   */
  void end() {
    spreadIslands();
    for (int i = 0; i < base.count(); i++) {
      if (isTold[i]) {
        told[toldCount++] = i;
      }
    }
    counts.set(RowKind.BODY, toldCount);
    Rows all = base.rows().joints();
    for (int i = 0; i < all.count(); i++) {
      if (isTold(all.get(i, JointRow.END_A)) || isTold(all.get(i, JointRow.END_B))) {
        add(RowKind.JOINT, i);
      }
    }
    all = base.rows().contacts();
    for (int i = 0; i < all.count(); i++) {
      if (isTold(all.get(i, ContactRow.END_A)) || isTold(all.get(i, ContactRow.END_B))) {
        add(RowKind.CONTACT, i);
      }
    }
    all = base.rows().of(RowKind.FIELDS);
    for (int i = 0; i < all.count(); i++) {
      if (isTold[all.get(i, FieldRow.PLACE)]) {
        add(RowKind.FIELDS, i);
      }
    }
  }

  private void spreadIslands() {
    boolean grew = true;
    while (grew) {
      grew = spread(base.rows().joints(), JointRow.END_A, JointRow.END_B);
      grew |= spread(base.rows().contacts(), ContactRow.END_A, ContactRow.END_B);
    }
  }

  /** Spreads the new islands over rows that tie two bodies; returns whether one grew. */
  private boolean spread(Rows ties, int endA, int endB) {
    boolean grew = false;
    for (int i = 0; i < ties.count(); i++) {
      int one = ties.get(i, endA);
      int other = ties.get(i, endB);
      if (one >= 0 && other >= 0 && inNewIsland[one] != inNewIsland[other]) {
        inNewIsland[one] = inNewIsland[other] = true;
        isTold[one] = isTold[other] = true;
        grew = true;
      }
    }
    return grew;
  }

  /**
   * Returns whether an end of a joint or contact is told. An end is a place in the list, or
   * negative for a static body of the level.
   */
  private boolean isTold(int end) {
    return end >= 0 && isTold[end];
  }

  private void add(RowKind kind, int row) {
    if (count() == NearState.MAX_ROWS) {
      return;
    }
    int at = count() - toldCount;
    if (at == others.length) {
      others = Arrays.copyOf(others, 2 * at);
    }
    others[at] = row;
    counts.set(kind, counts.get(kind) + 1);
  }

  /** Returns the number of rows. */
  int count() {
    return counts.total();
  }

  @Override
  public RowCounts counts() {
    return counts;
  }

  @Override
  public int toldCount() {
    return toldCount;
  }

  @Override
  public int told(int index) {
    return told[index];
  }

  @Override
  public int[] source(int row) {
    return base.rows().of(counts.kind(row)).ints();
  }

  @Override
  public int at(int row) {
    return base.rows()
        .of(counts.kind(row))
        .at(row < toldCount ? told[row] : others[row - toldCount]);
  }
}
