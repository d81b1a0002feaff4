package carom.server.prediction;

import carom.net.snapshot.exact.NearState;
import carom.physics.rows.ContactRow;
import carom.physics.rows.RowKind;
import carom.physics.rows.Rows;
import carom.sim.Simulation;
import carom.sim.near.Neighbourhood;
import java.util.Arrays;

/**
 * What an exact update holds: the state of the predicted set at one tick, the base, and which of it
 * is told. Told entities come first, in the order of the list, then the contacts of which at least
 * one end is told.
 *
 * <p>The room's thread; allocates only to grow.
 */
final class UpdateRows {
  private final Neighbourhood base = new Neighbourhood();

  /** By place in the list: whether the entity is told. */
  private boolean[] isTold = new boolean[16];

  /** By place in the list: whether the entity is in the island of a newcomer that is awake. */
  private boolean[] inNewIsland = new boolean[16];

  private int[] told = new int[16];
  private int toldCount;

  /** By row of a contact in the update: its row among the base's contacts. */
  private int[] contacts = new int[16];

  private int contactCount;

  /** Reads the base, of which nothing is told yet. */
  void begin(EntityList entities, Simulation simulation) {
    base.clear();
    for (int i = 0; i < entities.count(); i++) {
      base.add(entities.get(i));
    }
    base.read(simulation);
    toldCount = 0;
    contactCount = 0;
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
    Rows all = base.rows().contacts();
    for (int i = 0; i < all.count(); i++) {
      if (isTold(all.get(i, ContactRow.END_A)) || isTold(all.get(i, ContactRow.END_B))) {
        addContact(i);
      }
    }
  }

  private void spreadIslands() {
    Rows all = base.rows().contacts();
    boolean grew = true;
    while (grew) {
      grew = false;
      for (int i = 0; i < all.count(); i++) {
        int one = all.get(i, ContactRow.END_A);
        int other = all.get(i, ContactRow.END_B);
        if (one >= 0 && other >= 0 && inNewIsland[one] != inNewIsland[other]) {
          inNewIsland[one] = inNewIsland[other] = true;
          isTold[one] = isTold[other] = true;
          grew = true;
        }
      }
    }
  }

  /**
   * Returns whether an end of a contact is told. An end is a place in the list, or negative for a
   * static body of the level.
   */
  private boolean isTold(int end) {
    return end >= 0 && isTold[end];
  }

  private void addContact(int row) {
    if (count() == NearState.MAX_ROWS) {
      return;
    }
    if (contactCount == contacts.length) {
      contacts = Arrays.copyOf(contacts, 2 * contactCount);
    }
    contacts[contactCount++] = row;
  }

  /** Returns the number of rows. */
  int count() {
    return toldCount + contactCount;
  }

  /** Returns the number of told entities. Their rows come first. */
  int toldCount() {
    return toldCount;
  }

  /** Returns the place in the list of a told entity. */
  int told(int index) {
    return told[index];
  }

  /** Returns the kind of a row. */
  RowKind kind(int row) {
    return RowKind.of(row, toldCount, 0);
  }

  /** Returns the array that holds a row, from {@link #at} on. */
  int[] source(int row) {
    return base.rows().of(kind(row)).ints();
  }

  /** Returns where a row begins in {@link #source}. */
  int at(int row) {
    return switch (kind(row)) {
      case BODY -> base.rows().bodies().at(told[row]);
      case JOINT -> throw new IllegalStateException("row=" + row + " is a joint");
      case CONTACT -> base.rows().contacts().at(contacts[row - toldCount]);
    };
  }
}
