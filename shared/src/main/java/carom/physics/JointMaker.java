package carom.physics;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.joint.JointStore;

/** Fills in new joints: turns the world coordinates of definitions into those of bodies' frames. */
final class JointMaker {
  private final BodyStore store;
  private final JointStore joints;

  JointMaker(BodyStore store, JointStore joints) {
    this.store = store;
    this.joints = joints;
  }

  /** Fills in a new joint from its definition. */
  void fill(int j, JointDef<?> d) {
    int a = joints.bodyA[j];
    int b = joints.bodyB[j];
    float cA = a < 0 ? 1 : store.cos[a];
    float sA = a < 0 ? 0 : store.sin[a];
    joints.flags[j] = d.flags();
    joints.anchorAx[j] = a < 0 ? d.ax : localX(a, d.ax, d.ay);
    joints.anchorAy[j] = a < 0 ? d.ay : localY(a, d.ax, d.ay);
    joints.anchorBx[j] = localX(b, d.bx, d.by);
    joints.anchorBy[j] = localY(b, d.bx, d.by);
    joints.axisX[j] = cA * d.axisX + sA * d.axisY;
    joints.axisY[j] = cA * d.axisY - sA * d.axisX;
    joints.refCos[j] = store.cos[b] * cA + store.sin[b] * sA;
    joints.refSin[j] = store.sin[b] * cA - store.cos[b] * sA;
    joints.rest[j] = d.rest;
    couple(d, j);
    if (!d.restGiven && d.type == JointType.DISTANCE) {
      joints.rest[j] = length(d.bx - d.ax, d.by - d.ay);
    }
    joints.lower[j] = d.lower;
    joints.upper[j] = d.upper;
    joints.motorSpeed[j] = d.motorSpeed;
    joints.motorMax[j] = d.motorMax;
    joints.hertz[j] = d.hertz;
    joints.damping[j] = d.damping;
    joints.angularHertz[j] = d.angularHertz;
    joints.angularDamping[j] = d.angularDamping;
    joints.maxForce[j] = d.maxForce;
    joints.maxTorque[j] = d.maxTorque;
    joints.breakForce[j] = d.breakForce;
    joints.breakTorque[j] = d.breakTorque;
  }

  /** Sets the reference from which the coordinates of gear, rack and pulley count. */
  private void couple(JointDef<?> d, int j) {
    joints.ratio[j] = d.ratio;
    joints.baseAx[j] = d.baseAx;
    joints.baseAy[j] = d.baseAy;
    joints.baseBx[j] = d.baseBx;
    joints.baseBy[j] = d.baseBy;
    if (d.type == JointType.GEAR) {
      joints.baseAx[j] = d.bodyA.cos();
      joints.baseAy[j] = d.bodyA.sin();
      joints.baseBx[j] = d.bodyB.cos();
      joints.baseBy[j] = d.bodyB.sin();
    } else if (d.type == JointType.RACK) {
      float c = d.bodyB.cos();
      float s = d.bodyB.sin();
      joints.axisX[j] = c * d.axisX + s * d.axisY;
      joints.axisY[j] = c * d.axisY - s * d.axisX;
      joints.rest[j] = (d.bx - d.ax) * d.axisX + (d.by - d.ay) * d.axisY;
    } else if (d.type == JointType.PULLEY && !d.restGiven) {
      joints.rest[j] =
          length(d.ax - d.baseAx, d.ay - d.baseAy)
              + d.ratio * length(d.bx - d.baseBx, d.by - d.baseBy);
    }
  }

  private static float length(float x, float y) {
    return (float) Math.sqrt(x * x + y * y);
  }

  /** Returns the x coordinate of a world point in a body's frame. */
  private float localX(int body, float x, float y) {
    float dx = x - store.x[body];
    float dy = y - store.y[body];
    return store.localX[body] + (store.cos[body] * dx + store.sin[body] * dy);
  }

  private float localY(int body, float x, float y) {
    float dx = x - store.x[body];
    float dy = y - store.y[body];
    return store.localY[body] + (store.cos[body] * dy - store.sin[body] * dx);
  }
}
