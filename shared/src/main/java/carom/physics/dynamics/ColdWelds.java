package carom.physics.dynamics;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.store.IntList;

/**
 * Lets the welds of a beam start cold when a joint of it goes. Their impulses were in balance with
 * that joint, and may be thousands of times the weight of the pieces that are left: warm, they
 * would throw these about.
 */
final class ColdWelds {
  private final JointStore joints;
  private final BodyStore bodies;

  /** Bodies to look at. */
  private final IntList open = new IntList();

  /** Makes what is needed to find the welds of these joints and bodies. */
  public ColdWelds(JointStore joints, BodyStore bodies) {
    this.joints = joints;
    this.bodies = bodies;
  }

  /**
   * Forgets the impulses of all welds that hang together with a joint by welds.
   *
   * @param joint slot of the joint that goes
   */
  public void cool(int joint) {
    open.count = 0;
    add(joints.bodyA[joint]);
    add(joints.bodyB[joint]);
    while (open.count > 0) {
      int body = open.values[--open.count];
      for (int end = joints.firstEnd(body); end >= 0; end = joints.nextEnd(end)) {
        if (joints.isRigidWeld(end >> 1) && forget(end >> 1)) {
          add(joints.other(end));
        }
      }
    }
  }

  private void add(int body) {
    if (body >= 0 && bodies.invMass[body] > 0) {
      open.add(body);
    }
  }

  /** Forgets impulses. Returns whether there were any, which is so once for each weld. */
  private boolean forget(int weld) {
    boolean warm =
        joints.impulseX[weld] != 0 || joints.impulseY[weld] != 0 || joints.impulseW[weld] != 0;
    joints.impulseX[weld] = 0;
    joints.impulseY[weld] = 0;
    joints.impulseW[weld] = 0;
    return warm;
  }
}
