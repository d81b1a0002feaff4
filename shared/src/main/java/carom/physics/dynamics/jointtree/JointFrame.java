package carom.physics.dynamics.jointtree;

import static carom.physics.dynamics.domain.SolverBodies.STRIDE;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.joint.JointStore;

/** A joint and its two bodies as a step begins: the scratch of one worker that packs joints. */
public final class JointFrame {
  /** Slot of the joint. */
  public int slot;

  /** Slot of body B. */
  public int bodyB;

  /** Offsets of the bodies in {@code SolverBodies.state}, 0 for the world. */
  public int offsetA;

  public int offsetB;

  public float massA;
  public float massB;
  public float inertiaA;
  public float inertiaB;

  /** Axes along which the bodies' velocities are locked, see {@link BodyStore#linearLocks}. */
  public int locksA;

  public int locksB;

  /** Rotations of the bodies. */
  public float cosA;

  public float sinA;
  public float cosB;
  public float sinB;

  /** Lever arms of the anchors, m. */
  public float armAx;

  public float armAy;
  public float armBx;
  public float armBy;

  /** Centre of B relative to that of A, or to the anchor of the world, m. */
  public float gapX;

  public float gapY;

  /** Loads a joint. */
  public void load(int joint, JointStore j, BodyStore bodies, int[] slotOf) {
    slot = joint;
    int one = j.bodyA[slot];
    int two = j.bodyB[slot];
    bodyB = two;
    cosB = bodies.cos[two];
    sinB = bodies.sin[two];
    float bx = j.anchorBx[slot] - bodies.localX[two];
    float by = j.anchorBy[slot] - bodies.localY[two];
    offsetB = slotOf[two] * STRIDE;
    massB = bodies.invMass[two];
    inertiaB = bodies.invInertia[two];
    locksB = bodies.linearLocks(two);
    armBx = cosB * bx - sinB * by;
    armBy = sinB * bx + cosB * by;
    if (one < 0) {
      offsetA = 0;
      massA = 0;
      inertiaA = 0;
      locksA = 0;
      cosA = 1;
      sinA = 0;
      armAx = 0;
      armAy = 0;
      gapX = bodies.x[two] - j.anchorAx[slot];
      gapY = bodies.y[two] - j.anchorAy[slot];
      return;
    }
    offsetA = slotOf[one] * STRIDE;
    massA = bodies.invMass[one];
    inertiaA = bodies.invInertia[one];
    locksA = bodies.linearLocks(one);
    cosA = bodies.cos[one];
    sinA = bodies.sin[one];
    float ax = j.anchorAx[slot] - bodies.localX[one];
    float ay = j.anchorAy[slot] - bodies.localY[one];
    armAx = cosA * ax - sinA * ay;
    armAy = sinA * ax + cosA * ay;
    gapX = bodies.x[two] - bodies.x[one];
    gapY = bodies.y[two] - bodies.y[one];
  }
}
