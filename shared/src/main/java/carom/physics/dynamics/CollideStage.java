package carom.physics.dynamics;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.continuous.ContinuousCollision;
import carom.physics.dynamics.narrow.NarrowPhase;
import carom.physics.dynamics.narrow.Seams;
import carom.physics.dynamics.store.ParallelFor;
import carom.physics.settings.Settings;
import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * The stage of a step that updates the contacts. The narrow phase updates each row; this class
 * decides which rows with a sleeping body are left out, which bodies wake, and notes which bodies
 * overlap others deeply.
 *
 * <p>One thread at a time; the narrow phase itself shares its rows with other threads.
 */
final class CollideStage {
  private final Sleeping sleeping;
  private final Settings settings;
  private final BodyStore bodies;
  private final ContactTable contacts;
  private final NarrowPhase narrowPhase;
  private final Seams seams;
  private final ContinuousCollision continuous;

  /** Rows of sleeping bodies whose response was refused in the step before, ascending. */
  private int[] vetoedRows = new int[64];

  private int vetoedCount;

  /** True if a veto of the step before decides whether a sleeping body wakes. */
  private boolean undecided;

  private int touching;

  /** True if a row overlaps by more than the slop. */
  private boolean overlaps;

  CollideStage(
      Sleeping sleeping,
      Settings settings,
      BodyStore bodies,
      ShapeTable parts,
      ContactTable contacts,
      ParallelFor parallel,
      ContinuousCollision continuous) {
    this.sleeping = sleeping;
    this.settings = settings;
    this.bodies = bodies;
    this.contacts = contacts;
    this.continuous = continuous;
    narrowPhase = new NarrowPhase(settings, bodies, parts, contacts, parallel);
    seams = new Seams(settings, bodies, parts, contacts);
  }

  /** Returns the number of rows with contact points in this step, or the last one. */
  int touching() {
    return touching;
  }

  /**
   * Updates rows.
   *
   * @param all whether all, as first in every step, or only those that came since
   * @param dt length of the step, s
   * @param passes tells whether a callback lets the parts of a row pass each other
   */
  void run(boolean all, float dt, IntPredicate passes) {
    if (all) {
      touching = 0;
      overlaps = false;
      undecided = false;
      continuous.forgetOverlaps();
    }
    contacts.beginUpdate();
    narrowPhase.begin(all, dt);
    if (!all) {
      for (int row = 0; row < contacts.count(); row++) {
        if ((contacts.flags[row] & ContactTable.FRESH) == 0) {
          narrowPhase.leave(row);
        }
      }
    }
    vetoedCount = 0;
    if (sleeping.anyAsleep()) {
      leaveDormant();
    }
    touching += narrowPhase.run();
    touching -= seams.run(narrowPhase, passes);
    touching -= narrowPhase.dropMisses(passes);
    if (sleeping.anyAsleep()) {
      decide(passes);
    }
    overlaps |= narrowPhase.overlaps();
  }

  /** Excepts the rows in which nothing can have changed; lists those that had a veto. */
  private void leaveDormant() {
    for (int row = 0; row < contacts.count(); row++) {
      int sleeper = narrowPhase.isLeft(row) ? -1 : sleeper(row);
      if (sleeper >= 0 && dormant(row, sleeper)) {
        contacts.sleepOn(row);
        narrowPhase.leave(row);
      } else if (sleeper >= 0
          && contacts.touches(row)
          && (contacts.flags[row] & ContactTable.VETOED) != 0) {
        if (vetoedCount == vetoedRows.length) {
          vetoedRows = Arrays.copyOf(vetoedRows, 2 * vetoedCount);
        }
        vetoedRows[vetoedCount++] = row;
      }
    }
  }

  /** Decides which of the updated contacts wake a sleeping body. */
  private void decide(IntPredicate passes) {
    int next = 0;
    for (int row = 0; row < contacts.count(); row++) {
      boolean vetoed = next < vetoedCount && vetoedRows[next] == row;
      next += vetoed ? 1 : 0;
      if (!narrowPhase.isLeft(row) && !contacts.sensor(row)) {
        int sleeper = sleeper(row);
        if (sleeper >= 0) {
          decide(row, sleeper, vetoed, passes);
        }
      }
    }
  }

  /** Returns whether nothing can have changed between a sleeping body and one not awake either. */
  private boolean dormant(int row, int sleeper) {
    byte flags = contacts.flags[row];
    boolean fresh = (flags & ContactTable.FRESH) != 0 && (flags & ContactTable.TOUCHING) == 0;
    return !fresh && (flags & ContactTable.IGNORED) == 0 && !sleeping.drives(other(row, sleeper));
  }

  private int other(int row, int body) {
    return contacts.bodyA(row) == body ? contacts.bodyB(row) : contacts.bodyA(row);
  }

  /** Decides whether a contact wakes a sleeping body. */
  private void decide(int row, int sleeper, boolean vetoed, IntPredicate passes) {
    if (!contacts.touches(row)) {
      contacts.end(row); // nothing is in reserve for what sleeps
      if (!vetoed && (contacts.flags[row] & ContactTable.WAS_TOUCHING) != 0) {
        sleeping.touch(sleeper);
      }
    } else if (!sleeping.drives(other(row, sleeper))) {
      contacts.flags[row] |= ContactTable.DORMANT;
    } else if (vetoed) {
      undecided = true;
    } else if (!passes.test(row)) {
      sleeping.touch(sleeper);
    }
  }

  /** Makes the contacts touch in reserve that were pushed in the step. */
  void settleReserve() {
    narrowPhase.settleReserve();
  }

  /** Notes the dynamic bodies that overlap static or kinematic ones which don't let them pass. */
  void noteOverlaps() {
    if (!overlaps || !settings.continuous()) {
      return;
    }
    int passing = ContactTable.VETOED | ContactTable.DORMANT;
    for (int row = 0; row < contacts.count(); row++) {
      int a = contacts.bodyA(row);
      int b = contacts.bodyB(row);
      boolean dynamic = bodies.type[a] == BodyStore.DYNAMIC;
      // Types first: nearly all rows end here, and types are in the caches, unlike the contacts.
      if (dynamic != (bodies.type[b] == BodyStore.DYNAMIC)
          && (contacts.flags[row] & passing) == 0) {
        float overlap = -contacts.leastSeparation(row);
        if (overlap > settings.slop()) {
          continuous.noteOverlap(dynamic ? a : b, overlap);
        }
      }
    }
  }

  /** Keeps contacts with a sleeping body, whose veto just ended, from acting; it wakes next. */
  void holdBack() {
    if (!undecided) {
      return;
    }
    for (int row = 0; row < contacts.count(); row++) {
      int skipped = ContactTable.VETOED | ContactTable.DORMANT;
      if (contacts.points[row] > 0 && (contacts.flags[row] & skipped) == 0) {
        int sleeper = sleeper(row);
        if (sleeper >= 0) {
          contacts.flags[row] |= ContactTable.VETOED;
          sleeping.wake(sleeper);
        }
      }
    }
  }

  /** Returns the sleeping dynamic body of a row, -1 if there is none. */
  private int sleeper(int row) {
    int a = contacts.bodyA(row);
    int b = contacts.bodyB(row);
    return sleeping.sleepsDynamic(a) ? a : sleeping.sleepsDynamic(b) ? b : -1;
  }
}
