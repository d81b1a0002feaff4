package carom.physics.dynamics.joint;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.math.Limits;

/** Checks the numbers of joints that come from elsewhere. */
final class JointRanges {
  /** All flags of a joint. */
  static final byte FLAGS =
      JointStore.COLLIDE
          | JointStore.LIMITED
          | JointStore.DRIVEN
          | JointStore.SPRUNG
          | JointStore.WINDS;

  /** Flags that change while a joint exists. */
  static final byte CHANGEABLE_FLAGS = FLAGS & ~JointStore.COLLIDE;

  private JointRanges() {}

  /** Returns what is wrong with the numbers of a joint, or null if they are in their ranges. */
  static String problem(JointStore s, int j) {
    if (s.lower[j] > s.upper[j]) {
      return "joint=" + j + " has limits in the wrong order";
    }
    String problem = outside(j, "hertz", s.hertz[j], Limits.MAX_HERTZ);
    problem = first(problem, outside(j, "angular hertz", s.angularHertz[j], Limits.MAX_HERTZ));
    float most = Limits.MAX_DAMPING_RATIO;
    problem = first(problem, outside(j, "damping ratio", s.damping[j], most));
    problem = first(problem, outside(j, "angular damping ratio", s.angularDamping[j], most));
    float speed = Math.abs(s.motorSpeed[j]);
    problem = first(problem, outside(j, "motor speed", speed, Limits.MAX_VELOCITY));
    problem = first(problem, outside(j, "most of the motor", s.motorMax[j], Limits.MAX_FORCE));
    problem = first(problem, outside(j, "most force", s.maxForce[j], Limits.MAX_FORCE));
    problem = first(problem, outside(j, "most torque", s.maxTorque[j], Limits.MAX_FORCE));
    problem = first(problem, outside(j, "ratio", Math.abs(s.ratio[j]), Limits.MAX_RATIO));
    most = Float.POSITIVE_INFINITY;
    problem = first(problem, outside(j, "breaking force", s.breakForce[j], most));
    return first(problem, outside(j, "breaking torque", s.breakTorque[j], most));
  }

  private static String first(String one, String other) {
    return one == null ? other : one;
  }

  /** Returns a complaint unless a number of a joint is 0..most. */
  private static String outside(int joint, String what, float value, float most) {
    return value >= 0 && value <= most
        ? null
        : what + "=" + value + " of joint=" + joint + " is outside 0.." + most;
  }

  /** Returns the nearest number in a range; NaN gives the least. */
  static float within(float value, float least, float most) {
    return value >= least ? Math.min(value, most) : least;
  }

  /** Returns a number that an archive would accept; NaN gives 0. */
  static float finite(float value) {
    return Float.isNaN(value) ? 0 : within(value, -BodyStore.MOST, BodyStore.MOST);
  }
}
