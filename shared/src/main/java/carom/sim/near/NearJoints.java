package carom.sim.near;

import carom.physics.Body;
import carom.physics.Joint;
import carom.physics.rows.ExactRows;
import carom.physics.rows.JointRow;
import carom.physics.rows.Rows;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.JointTable;

/**
 * The joints of a {@link Neighbourhood}: gives the rows that a world read their keys, and makes the
 * joints of rows in another simulation.
 *
 * <p>A row's settings are stored as their difference to the joint's definition, bit by bit
 * (exclusive or). They are zero unless the game changed them, so they cost next to nothing to send.
 */
final class NearJoints {
  private final int[] definition = new int[JointDefinitions.INTS];

  NearJoints() {}

  /** Completes the rows of joints that a world has read. */
  void read(SimulationHost s, ExactRows rows) {
    Rows joints = rows.joints();
    for (int i = 0; i < joints.count(); i++) {
      joints.set(i, JointRow.KEY, s.joints().key(rows.jointSlot(i)));
      toggle(s.joints(), rows, i);
    }
  }

  /** Turns the settings of a row into their difference to the definition, or back. */
  private static void toggle(JointTable<HostEntity> table, ExactRows rows, int row) {
    int[] ints = rows.joints().ints();
    int at = rows.joints().at(row) + JointRow.SETTINGS;
    for (int i = 0; i < JointRow.SETTING_INTS; i++) {
      ints[at + i] ^= table.definition(rows.jointSlot(row), JointRow.definedBy(i));
    }
  }

  /**
   * Makes the joints of the rows, whose bodies have been made, and gives the rows their slots. A
   * joint is left out if its definition is unknown or damaged, or one of its ends is no body.
   */
  void make(SimulationHost s, ExactRows rows, JointDefinitions definitions) {
    Rows joints = rows.joints();
    for (int i = 0; i < joints.count(); i++) {
      Joint<HostEntity> joint = null;
      if (definitions.read(joints.get(i, JointRow.KEY), definition)) {
        joint = make(s, rows, i);
      }
      rows.setJointSlot(i, joint == null ? -1 : joint.index());
    }
  }

  private Joint<HostEntity> make(SimulationHost s, ExactRows rows, int row) {
    int endA = rows.joints().get(row, JointRow.END_A);
    HostEntity a = entity(s, rows, endA);
    HostEntity b = entity(s, rows, rows.joints().get(row, JointRow.END_B));
    if (b == null || (a == null && endA != JointRow.GROUND)) {
      return null;
    }
    try {
      return s.mirror()
          .connect(
              rows.joints().get(row, JointRow.KEY),
              definition[JointDefinitions.ROOT],
              definition[JointDefinitions.NUMBER],
              a,
              b,
              definition,
              JointDefinitions.DEFINITION);
    } catch (IllegalArgumentException e) {
      return null; // from a server that isn't one
    }
  }

  private static HostEntity entity(SimulationHost s, ExactRows rows, int end) {
    if (end == JointRow.GROUND || end >= rows.bodies().count()) {
      return null;
    }
    Body<HostEntity> body = s.world().body(end >= 0 ? rows.slot(end) : ~end);
    return body == null || (end < 0 && !body.user().isLevel()) ? null : body.user();
  }

  /** Turns the settings of all rows into what the physics reads, or back into differences. */
  void toggle(SimulationHost s, ExactRows rows) {
    for (int i = 0; i < rows.joints().count(); i++) {
      if (rows.jointSlot(i) >= 0) {
        toggle(s.joints(), rows, i);
      }
    }
  }
}
