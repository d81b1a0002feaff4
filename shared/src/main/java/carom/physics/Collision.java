package carom.physics;

import carom.physics.dynamics.ContactOverrides;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.geometry.Shape;
import carom.physics.math.Limits;

/**
 * Two touching shapes, as a {@link CollisionListener} sees them. The world has one such object and
 * reuses it for each call: don't keep it.
 *
 * <p>Self is the body with the smaller {@link Body#index()}. A listener that looks for one of the
 * two bodies uses {@link #isSelf} and {@link #other(Body)}. Directions are seen from self.
 *
 * @param <T> the user's type of {@link Body#user()}
 */
public final class Collision<T> {
  private final World<T> world;
  private final ContactTable contacts;
  private ContactTable table;
  private int row;
  private float hitSpeed;
  private boolean swept;

  Collision(World<T> world, ContactTable table) {
    this.world = world;
    contacts = table;
  }

  Collision<T> at(int newRow) {
    return at(newRow, 0);
  }

  Collision<T> at(int newRow, float newHitSpeed) {
    table = contacts;
    row = newRow;
    hitSpeed = newHitSpeed;
    swept = false;
    return this;
  }

  Collision<T> atSwept(ContactTable only) {
    at(0);
    table = only;
    swept = true;
    return this;
  }

  /**
   * Returns the body with the smaller index.
   *
   * @return self
   */
  public Body<T> self() {
    return world.body(table.bodyA(row));
  }

  /**
   * Returns the body with the larger index.
   *
   * @return other
   */
  public Body<T> other() {
    return world.body(table.bodyB(row));
  }

  /**
   * Returns whether one of the shapes is a sensor, which was entered or left. A sensor pushes
   * nothing.
   *
   * @return true in {@code begin} and {@code end} of sensors; there are no points then
   */
  public boolean isSensor() {
    return table.sensor(row);
  }

  /**
   * Returns whether this is a question of continuous collision: a fast body would be stopped here
   * within the step. Bodies are at the place of the impact then, with the velocities of the end of
   * the step, and points may have a gap.
   *
   * @return true in some calls of {@link CollisionListener#preSolve}
   */
  public boolean isSwept() {
    return swept;
  }

  /**
   * Returns the partner of one of the two bodies.
   *
   * @param body self or other
   * @return the other one of the two
   */
  public Body<T> other(Body<T> body) {
    return isSelf(body) ? other() : self();
  }

  /**
   * Returns whether a body is {@link #self}, from which directions are seen.
   *
   * @param body one of the two
   * @return true for self; if false, negate the normal and the MTV
   */
  public boolean isSelf(Body<T> body) {
    return self() == body;
  }

  /**
   * Returns the touching shape of self, as it was given to {@link BodyDef#shape}.
   *
   * @return the shape, in the body frame
   */
  public Shape selfShape() {
    return self().shape(selfShapeIndex());
  }

  /**
   * Returns the number of the touching shape of self.
   *
   * @return below {@link Body#shapeCount}
   */
  public int selfShapeIndex() {
    return world.dynamics().queries().shapeOf(table.partA(row));
  }

  /**
   * Returns the number of the touching shape of the other body.
   *
   * @return below {@link Body#shapeCount}
   */
  public int otherShapeIndex() {
    return world.dynamics().queries().shapeOf(table.partB(row));
  }

  /**
   * Returns the material of the touching shape of self.
   *
   * @return the material
   */
  public Material selfMaterial() {
    return self().material(selfShapeIndex());
  }

  /**
   * Returns the material of the touching shape of the other body.
   *
   * @return the material
   */
  public Material otherMaterial() {
    return other().material(otherShapeIndex());
  }

  /**
   * Returns the touching shape of the other body, as it was given to {@link BodyDef#shape}.
   *
   * @return the shape, in the body frame
   */
  public Shape otherShape() {
    return other().shape(otherShapeIndex());
  }

  /**
   * Returns the x component of the unit normal from self to other.
   *
   * @return -1..1
   */
  public float normalX() {
    return table.normalX(row);
  }

  /**
   * Returns the y component of the unit normal from self to other.
   *
   * @return -1..1
   */
  public float normalY() {
    return table.normalY(row);
  }

  /**
   * Returns how deep the shapes overlap along the normal.
   *
   * @return m, not negative; 0 if they are merely close
   */
  public float depth() {
    float least = 0;
    for (int i = 0; i < pointCount(); i++) {
      least = Math.min(least, table.separation(row, i));
    }
    return 0 - least;
  }

  /**
   * Returns the x component of the minimum translation vector (MTV), which moves self out of other.
   *
   * @return m; zero if the shapes are merely close, see {@link #normalX} for the direction
   */
  public float mtvX() {
    return -depth() * normalX();
  }

  /**
   * Returns the y component of the minimum translation vector (MTV), which moves self out of other.
   *
   * @return m; zero if the shapes are merely close, see {@link #normalY} for the direction
   */
  public float mtvY() {
    return -depth() * normalY();
  }

  /**
   * Returns the number of contact points.
   *
   * @return 1 or 2; 0 when a collision ended, and for sensors
   */
  public int pointCount() {
    return table.points(row);
  }

  /**
   * Returns the x coordinate of a contact point, which is midway between the surfaces.
   *
   * @param i number of the point, below {@link #pointCount}
   * @return m, world
   */
  public float pointX(int i) {
    return self().centerX() + table.pointX(row, check(i));
  }

  /**
   * Returns the y coordinate of a contact point, which is midway between the surfaces.
   *
   * @param i number of the point, below {@link #pointCount}
   * @return m, world
   */
  public float pointY(int i) {
    return self().centerY() + table.pointY(row, check(i));
  }

  /**
   * Returns the gap between the surfaces at a contact point.
   *
   * @param i number of the point, below {@link #pointCount}
   * @return m, negative when the surfaces overlap
   */
  public float separation(int i) {
    return table.separation(row, check(i));
  }

  /**
   * Returns the impulse of the step on the other body, along the normal, at one point. Self
   * receives the opposite.
   *
   * @param i number of the point, below {@link #pointCount}
   * @return N s, not negative; 0 in begin and pre-solve
   */
  public float normalImpulse(int i) {
    return table.impulse(row, check(i));
  }

  /**
   * Returns the impulse of the step on the other body, along the normal, of all points together.
   * Self receives the opposite.
   *
   * @return N s, not negative; 0 in begin and pre-solve
   */
  public float impulse() {
    float sum = 0;
    for (int i = 0; i < pointCount(); i++) {
      sum += table.impulse(row, i);
    }
    return sum;
  }

  /**
   * Returns the speed at which the bodies approached each other at the contact, along the normal,
   * when the step began.
   *
   * @return m/s, positive; 0 anywhere but in {@link CollisionListener#hit}
   */
  public float hitSpeed() {
    return hitSpeed;
  }

  /**
   * Returns the x coordinate of the mean of the contact points, weighted by their impulses. The
   * impulse of the step acted there.
   *
   * @return m, world
   */
  public float hitX() {
    float x = table.pointX(row, 0);
    return self().centerX() + x + secondShare() * (table.pointX(row, 1) - x);
  }

  /**
   * Returns the y coordinate of the mean of the contact points, weighted by their impulses. The
   * impulse of the step acted there.
   *
   * @return m, world
   */
  public float hitY() {
    float y = table.pointY(row, 0);
    return self().centerY() + y + secondShare() * (table.pointY(row, 1) - y);
  }

  /** Returns the second point's share of the impulse, 0..1. */
  private float secondShare() {
    float sum = impulse();
    return pointCount() > 1 && sum > 0 ? table.impulse(row, 1) / sum : 0;
  }

  /**
   * Returns the warm-start impulse of a point: the impulse along the normal that it carries over
   * from the step before. It is above 0 in pre-solve if the contact carried a load before.
   *
   * @param i number of the point, below {@link #pointCount}
   * @return N s per substep, not negative; 0 for a new point and after a veto
   */
  public float warmImpulse(int i) {
    return table.warmImpulse(row, check(i));
  }

  /**
   * Returns the friction impulse of the step on the other body, along the normal turned left, at
   * one point.
   *
   * @param i number of the point, below {@link #pointCount}
   * @return N s
   */
  public float tangentImpulse(int i) {
    return table.slide(row, check(i));
  }

  /**
   * Returns the friction of the contact: that of the two shapes, mixed as {@link Material} says, or
   * what {@link #setFriction} has set in this step.
   *
   * @return Coulomb coefficient
   */
  public float friction() {
    return table.friction(row);
  }

  /**
   * Returns the restitution of the contact: that of the two shapes, mixed as {@link Material} says,
   * or what {@link #setRestitution} has set in this step.
   *
   * @return ratio of the speed after a bounce to the speed before
   */
  public float restitution() {
    return table.restitution(row);
  }

  /**
   * Returns the tangent speed of the contact: that of both shapes together, or what {@link
   * #setTangentSpeed} has set in this step.
   *
   * @return m/s; seen from self, a positive speed drives the other body along the normal turned
   *     right
   */
  public float tangentSpeed() {
    return table.surface(row);
  }

  /**
   * Sets the friction of this contact for this step. In the next step the contact has the friction
   * of its shapes again, so a listener that wants to keep it sets it in each {@code preSolve}. It
   * is no part of the world's state, because it follows from the listener. If the collision {@link
   * #isSwept}, there is nothing to set yet, and this does nothing.
   *
   * @param friction Coulomb coefficient, 0..100
   * @throws IllegalStateException anywhere but in {@link CollisionListener#preSolve}
   */
  public void setFriction(float friction) {
    set("setFriction", ContactTable.FRICTION, Limits.range("friction", friction, 0, 100));
  }

  /**
   * Sets the restitution of this contact for this step, as {@link #setFriction} does.
   *
   * @param restitution 0..2; acts above {@link WorldDef#restitutionThreshold}
   * @throws IllegalStateException anywhere but in {@link CollisionListener#preSolve}
   */
  public void setRestitution(float restitution) {
    set("setRestitution", ContactTable.RESTITUTION, Limits.range("restitution", restitution, 0, 2));
  }

  /**
   * Sets the tangent speed of this contact for this step, as {@link #setFriction} does: a conveyor
   * belt that works only here or now. It takes the place of both shapes' tangent speeds.
   *
   * @param speed m/s, within 1e5; seen from self, a positive speed drives the other body along the
   *     normal turned right. On a floor it drives what lies on it to the right, whichever of the
   *     two is self
   * @throws IllegalStateException anywhere but in {@link CollisionListener#preSolve}
   */
  public void setTangentSpeed(float speed) {
    set("setTangentSpeed", ContactTable.SURFACE, Limits.velocity("tangentSpeed", speed));
  }

  private void set(String what, int place, float value) {
    if (swept) {
      return; // the body stops or passes; the contact of the next step is asked about again
    }
    ContactOverrides overrides = world.dynamics().contactOverrides();
    if (!overrides.decides(row)) {
      throw new IllegalStateException(what + " is possible in preSolve only");
    }
    world.note(Call.SET_CONTACT, place, value);
    overrides.set(row, place, value);
  }

  /** Sets again what was recorded; a place that isn't one is refused. */
  void repeat(int place, float value) {
    switch (place) {
      case ContactTable.FRICTION -> setFriction(value);
      case ContactTable.RESTITUTION -> setRestitution(value);
      case ContactTable.SURFACE -> setTangentSpeed(value);
      default -> throw new IllegalArgumentException("place=" + place + " of a contact's numbers");
    }
  }

  /**
   * Returns the length of the step.
   *
   * @return s; outside of a step that of the last one
   */
  public float stepSeconds() {
    return world.stepSeconds();
  }

  /**
   * Returns the speed at which the two bodies separate at a point now, along the normal.
   *
   * @param i number of the point, below {@link #pointCount}
   * @return m/s, negative when they approach
   */
  public float normalSpeed(int i) {
    Body<T> a = self();
    Body<T> b = other();
    float ax = table.pointX(row, check(i));
    float ay = table.pointY(row, i);
    float bx = ax - (b.centerX() - a.centerX());
    float by = ay - (b.centerY() - a.centerY());
    float dx =
        b.velocityX() - b.angularVelocity() * by - (a.velocityX() - a.angularVelocity() * ay);
    float dy =
        b.velocityY() + b.angularVelocity() * bx - (a.velocityY() + a.angularVelocity() * ax);
    return dx * normalX() + dy * normalY();
  }

  private int check(int i) {
    if (i < 0 || i >= pointCount()) {
      throw new IndexOutOfBoundsException(
          "point=" + i + " is outside 0.." + (pointCount() - 1) + "; see pointCount()");
    }
    return i;
  }
}
