package carom.sim.level;

import carom.physics.rows.JointDefRow;

/**
 * A joint that the level places. Its definition is in the frames of its bodies, so that server and
 * clients make the same joint, to the bit, without a byte on the wire.
 *
 * @param name for {@code Simulation.joint}; empty for none
 * @param a body A: a number in {@link Level#bodies}, an inverted one ({@code ~number}) in {@link
 *     Level#statics}, or {@link #GROUND}
 * @param b body B: a number in {@link Level#bodies}, or an inverted one in {@link Level#statics}
 * @param definition {@link JointDefRow#INTS} ints, which must not be changed
 */
public record LevelJoint(String name, int a, int b, int[] definition) {
  /** The end of a joint that holds a body to the world. */
  public static final int GROUND = Integer.MIN_VALUE;
}
