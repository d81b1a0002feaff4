package carom.sim.ruling;

import carom.physics.Body;
import carom.physics.rows.BodyRow;
import carom.sim.entity.Entity;
import carom.sim.level.Archetype;
import carom.sim.level.Archetypes;

/**
 * A change that a game's rules made to the state of one body, in {@code Game.beforeStep} or {@code
 * Game.afterStep} of a tick: an impulse, a force, another velocity or place. It holds the new bits
 * of each number that changed, so applying it to the same state gives the same state.
 *
 * <p>Mutable, reused; one thread.
 */
public final class Ruling {
  /** Number of bits of {@link #mask}: the ints of a body's row from {@link BodyRow#MOTION} on. */
  public static final int WORDS = BodyRow.CHANGING_INTS;

  /** Bit of {@link #mask} that says that the entity became another archetype. */
  static final int ARCHETYPE = 1 << BodyRow.ARCHETYPE - BodyRow.MOTION;

  /** The tick in which the rules changed the body. */
  public int tick;

  /** Whether they did so after the physics of the tick, instead of before the inputs. */
  public boolean afterStep;

  /** Slot and generation of the entity: {@code slot | generation << 16}. */
  public int key;

  /** Bit i says that int {@code BodyRow.MOTION + i} of the body's row changed. */
  public int mask;

  /** New values of the ints that changed, at the places of a row; others hold anything. */
  public final int[] row = new int[BodyRow.INTS];

  /** Creates a ruling of nothing. */
  public Ruling() {}

  /** Copies another ruling. */
  public void set(Ruling other) {
    tick = other.tick;
    afterStep = other.afterStep;
    key = other.key;
    mask = other.mask;
    System.arraycopy(other.row, 0, row, 0, row.length);
  }

  /** Returns whether both are about the same moment of the same entity. */
  public boolean isSameMoment(Ruling other) {
    return tick == other.tick && afterStep == other.afterStep && key == other.key;
  }

  /** Reads the row of an entity, which rulings compare. */
  static void readRow(Entity entity, int[] row) {
    entity.body().readRow(row, 0);
    row[BodyRow.ARCHETYPE] = entity.archetype().index();
  }

  /**
   * Compares two states of a body and makes this the difference.
   *
   * @param before row before the rules
   * @param after row after them
   */
  public void setDifference(int[] before, int[] after) {
    mask = 0;
    for (int i = 0; i < WORDS; i++) {
      int at = BodyRow.MOTION + i;
      if (before[at] != after[at]) {
        mask |= 1 << i;
        row[at] = after[at];
      }
    }
  }

  /**
   * Applies the change to an entity.
   *
   * @param archetypes those of its simulation
   * @param scratch room for a row
   */
  public void apply(Entity entity, Archetypes archetypes, int[] scratch) {
    Body<Entity> body = entity.body();
    if ((mask & ARCHETYPE) != 0 && !entity.isRoot()) {
      Archetype other = archetypes.get(row[BodyRow.ARCHETYPE]);
      entity.become(other == null ? entity.archetype() : other);
    }
    body.readRow(scratch, 0);
    if (scratch[BodyRow.SLEEP_TIME] == BodyRow.ASLEEP) {
      scratch[BodyRow.SLEEP_TIME] = 0; // it wakes
    }
    for (int i = 0; i < BodyRow.STATE_INTS; i++) {
      if ((mask & 1 << i) != 0) {
        scratch[BodyRow.MOTION + i] = row[BodyRow.MOTION + i];
      }
    }
    body.writeRow(scratch, 0);
  }

  /**
   * Returns whether the numbers are such that a body can have them: all finite, and the body awake.
   * A ruling from a datagram may fail this.
   */
  public boolean isSane() {
    for (int i = 0; i < BodyRow.STATE_INTS; i++) {
      float value = Float.intBitsToFloat(row[BodyRow.MOTION + i]);
      if ((mask & 1 << i) != 0 && !(Math.abs(value) < 1e9f)) {
        return false;
      }
    }
    return true;
  }
}
