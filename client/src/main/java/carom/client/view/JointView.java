package carom.client.view;

import carom.physics.JointType;

/**
 * One joint as drawn, between two places of the picture, with the settings that the game has given
 * it since. Reused from frame to frame.
 */
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
  boolean limited;
  boolean driven;
  float rest;
  float lower;
  float upper;
  float motorSpeed;
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

  /** Returns x of the anchor on body A, or of the target of a mouse joint, metres. */
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

  /** Returns the length of a spring at ease or of a rod, metres, or an angle at ease, radians. */
  public float rest() {
    return rest;
  }

  /** Returns whether it has limits. A rope is a distance joint with limits. */
  public boolean isLimited() {
    return limited;
  }

  /** Returns the lower limit, metres or radians. */
  public float lower() {
    return lower;
  }

  /** Returns the upper limit, metres or radians: the length of a rope. */
  public float upper() {
    return upper;
  }

  /** Returns whether a motor drives it. */
  public boolean isDriven() {
    return driven;
  }

  /** Returns the speed that its motor aims at, m/s or rad/s. */
  public float motorSpeed() {
    return motorSpeed;
  }

  /** Returns the opacity, 0..1: that of the fainter body. */
  public float alpha() {
    return alpha;
  }
}
