package carom.sim.ruling;

import carom.physics.Body;
import carom.physics.Joint;
import carom.physics.rows.BodyRow;
import carom.sim.entity.HostEntity;
import carom.sim.level.Archetype;
import carom.sim.level.Archetypes;

/**
 * A change that a game made to the state of one body or joint in a tick, and that a client can't
 * compute. The game made it in {@code Game.beforeStep} or {@code Game.afterStep}, or in a {@code
 * Game.input} that read what the client isn't told. It may be an impulse, a force, another velocity
 * or place, or another setting of a joint. It holds the new bits of each number that changed, so
 * applying it to the same state gives the same state.
 *
 * <p>Mutable, reused; one thread.
 */
public final class Ruling {
  /** The moment in a tick at which a game changes bodies. */
  public enum Moment {
    /** The game ruled before the inputs. */
    BEFORE_STEP,
    /**
     * The game ruled in the input of the entity's owner; the ruling says all that the input did.
     */
    INPUT,
    /** The game ruled after the physics. */
    AFTER_STEP
  }

  /** Value of {@link #joint} of a change to the body. */
  public static final int BODY = -1;

  /** Number of bits of {@link #mask}: the ints of a body's row from {@link BodyRow#MOTION} on. */
  public static final int WORDS = BodyRow.CHANGING_INTS;

  /** Bit of {@link #mask} that says that the entity became another archetype. */
  static final int ARCHETYPE = 1 << BodyRow.ARCHETYPE - BodyRow.MOTION;

  /** The tick in which the game made the change. */
  public int tick;

  /** The moment in the tick at which the game made the change. */
  public Moment moment = Moment.BEFORE_STEP;

  /** Slot and generation of the entity: {@code slot | generation << 16}. */
  public int key;

  /** Index of one of the body's joints in the server's table of joints, or {@link #BODY}. */
  public int joint = BODY;

  /**
   * Bits that say which numbers changed. For a body, bit i stands for int {@code BodyRow.MOTION +
   * i} of its row. For a joint it stands for number i of the settings: flags (1 driven, 2 limited,
   * 4 sprung), motor speed and maximum, lower and upper limit, hertz, damping ratio, rest, target x
   * and y.
   */
  public int mask;

  /**
   * New values of what changed: bit i of {@link #mask} has place {@code BodyRow.MOTION + i}. Others
   * hold anything.
   */
  public final int[] row = new int[BodyRow.INTS];

  /** Creates a ruling of nothing. */
  public Ruling() {}

  /** Copies another ruling. */
  public void set(Ruling other) {
    tick = other.tick;
    moment = other.moment;
    key = other.key;
    joint = other.joint;
    mask = other.mask;
    System.arraycopy(other.row, 0, row, 0, row.length);
  }

  /** Returns whether both are about the same moment of the same body or joint. */
  public boolean isSameMoment(Ruling other) {
    return tick == other.tick && moment == other.moment && key == other.key && joint == other.joint;
  }

  /** Reads the row of an entity, which rulings compare. */
  static void readRow(HostEntity entity, int[] row) {
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
    joint = BODY;
    for (int i = 0; i < WORDS; i++) {
      int at = BodyRow.MOTION + i;
      if (before[at] != after[at]) {
        mask |= 1 << i;
        row[at] = after[at];
      }
    }
  }

  /**
   * Compares two settings of a joint and makes this the difference.
   *
   * @param index of the joint in the table of joints
   * @param before holds {@link JointSettings}
   * @param after holds them at the same place
   * @param at where they begin
   */
  void setDifference(int index, int[] before, int[] after, int at) {
    mask = 0;
    joint = index;
    for (int i = 0; i < JointSettings.INTS; i++) {
      if (before[at + i] != after[at + i]) {
        mask |= 1 << i;
        row[BodyRow.MOTION + i] = after[at + i];
      }
    }
  }

  /**
   * Applies the change to a joint. Nothing happens if a joint of its type can't have the settings.
   *
   * @param scratch room for a row
   */
  public void apply(Joint<HostEntity> target, int[] scratch) {
    try {
      JointSettings.change(target, mask, row, BodyRow.MOTION, scratch);
    } catch (IllegalArgumentException | IllegalStateException e) {
      return; // from a server that isn't one
    }
  }

  /**
   * Applies the change to an entity's body.
   *
   * @param archetypes those of its simulation
   * @param scratch room for a row
   */
  public void apply(HostEntity entity, Archetypes archetypes, int[] scratch) {
    Body<HostEntity> body = entity.body();
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
   * Returns whether the numbers are such that a body or joint can have them: all finite, and the
   * body awake. A ruling from a datagram may fail this.
   */
  public boolean isSane() {
    for (int i = 0; joint != BODY && i < WORDS; i++) {
      if ((mask & 1 << i) != 0 && !JointSettings.isSane(i, row[BodyRow.MOTION + i])) {
        return false;
      }
    }
    if (joint != BODY) {
      return true;
    }
    for (int i = 0; i < BodyRow.STATE_INTS; i++) {
      float value = Float.intBitsToFloat(row[BodyRow.MOTION + i]);
      if ((mask & 1 << i) != 0 && !(Math.abs(value) < 1e9f)) {
        return false;
      }
    }
    return true;
  }
}
