package carom.physics.dynamics;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.joint.JointStore;

/**
 * Decides which joints the solver looks at: those of which a body is active, and no other one is
 * asleep that the joint could move.
 */
final class JointActivity {
  private final BodyStore bodies;
  private final ActiveBodies active;
  private final JointStore joints;

  JointActivity(BodyStore bodies, ActiveBodies active, JointStore joints) {
    this.bodies = bodies;
    this.active = active;
    this.joints = joints;
  }

  /** Decides anew about the joints of a body that came, went, woke or fell asleep. */
  public void refreshBody(int body) {
    for (int end = joints.firstEnd(body); end >= 0; end = joints.nextEnd(end)) {
      refresh(end >> 1);
    }
  }

  /** Decides anew about a joint. */
  public void refresh(int joint) {
    int a = joints.bodyA[joint];
    int b = joints.bodyB[joint];
    boolean awake = active.contains(b) || (a >= 0 && active.contains(a));
    boolean waits = sleepsDynamic(b) || (a >= 0 && sleepsDynamic(a));
    joints.setAwake(joint, awake && !waits);
    if (!awake && !waits) {
      joints.forget(joint);
    }
  }

  private boolean sleepsDynamic(int body) {
    return bodies.type[body] == BodyStore.DYNAMIC && bodies.asleep(body);
  }
}
