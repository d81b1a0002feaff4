package carom.client.view;

import carom.physics.JointType;

/** One joint as drawn, between two places of the picture. Reused from frame to frame. */
public final class JointView {
  int index;
  JointType type;
  float ax;
  float ay;
  float bx;
  float by;
  float groundAX;
  float groundAY;
  float groundBX;
  float groundBY;
  boolean sprung;
  float rest;
  float alpha;
  int bodyA;
  int bodyB;

  JointView() {}

  /** Returns its index in the server's world. */
  public int index() {
    return index;
  }

  /** Returns its type. */
  public JointType type() {
    return type;
  }

  /** Returns the id of the entity that is body A, or -1 for a static or the world. */
  public int bodyA() {
    return bodyA;
  }

  /** Returns the id of the entity that is body B, or -1 for a static. */
  public int bodyB() {
    return bodyB;
  }

  /** Returns x of the anchor on body A, metres. */
  public float ax() {
    return ax;
  }

  /** Returns y of the anchor on body A, metres. */
  public float ay() {
    return ay;
  }

  /** Returns x of the anchor on body B, metres. */
  public float bx() {
    return bx;
  }

  /** Returns y of the anchor on body B, metres. */
  public float by() {
    return by;
  }

  /** Returns x of the point of the world over which a pulley's rope to A runs, metres. */
  public float groundAX() {
    return groundAX;
  }

  /** Returns y of that point, metres. */
  public float groundAY() {
    return groundAY;
  }

  /** Returns x of the point of the world over which a pulley's rope to B runs, metres. */
  public float groundBX() {
    return groundBX;
  }

  /** Returns y of that point, metres. */
  public float groundBY() {
    return groundBY;
  }

  /** Returns whether it gives way as a spring. */
  public boolean isSprung() {
    return sprung;
  }

  /** Returns the length of a spring at ease, metres. */
  public float rest() {
    return rest;
  }

  /** Returns the opacity, 0..1: that of the fainter body. */
  public float alpha() {
    return alpha;
  }
}
