package carom.sim.near;

import carom.physics.rows.JointDefRow;
import carom.sim.entity.JointTable;

/** Knows what a server's joints were made with. */
@FunctionalInterface
public interface JointDefinitions {
  /** The root of the joint's assembly, as {@link JointTable#root} returns it. */
  int ROOT = 0;

  /** Number of the joint in its assembly. */
  int NUMBER = ROOT + 1;

  /** The first int of its {@link JointDefRow}. */
  int DEFINITION = NUMBER + 1;

  /** Number of ints. */
  int INTS = DEFINITION + JointDefRow.INTS;

  /**
   * Reads what a joint was made with.
   *
   * @param key of the joint
   * @param to receives {@link #INTS} ints
   * @return false if the joint is unknown
   */
  boolean read(int key, int[] to);

  /** Returns the definitions of the joints of a simulation that is the authority. */
  static JointDefinitions of(JointTable<?> joints) {
    return (key, to) -> {
      int index = JointTable.index(key);
      boolean known =
          index < joints.limit() && joints.get(index) != null && joints.key(index) == key;
      if (known) {
        to[ROOT] = joints.root(index);
        to[NUMBER] = joints.number(index);
        joints.definition(index, to, DEFINITION);
      }
      return known;
    };
  }
}
