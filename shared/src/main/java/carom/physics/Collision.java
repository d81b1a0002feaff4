package carom.physics;

import carom.physics.dynamics.contact.ContactTable;
import carom.physics.geometry.Shape;

/**
 * Two touching shapes, as a {@link CollisionListener} sees them. One object per world that is used
 * again for each call: don't keep it.
 *
 * <p>Self is the body with the smaller {@link Body#index()}; {@link #isSelf} and {@link #other}
 * help those who look for one of the two. Directions are seen from self.
 *
 * @param <T> the user's type of {@link Body#user()}
 */
public final class Collision<T> {
  private final World<T> world;
  private final ContactTable table;
  private int row;
  private float hitSpeed;

  Collision(World<T> world, ContactTable table) {
    this.world = world;
    this.table = table;
  }

  Collision<T> at(int newRow) {
    return at(newRow, 0);
  }

  Collision<T> at(int newRow, float newHitSpeed) {
    row = newRow;
    hitSpeed = newHitSpeed;
    return this;
  }

  /**
   * The body with the smaller index.
   *
   * @return self
   */
  public Body<T> self() {
    return world.body(table.bodyA(row));
  }

  /**
   * The body with the larger index.
   *
   * @return the other one
   */
  public Body<T> other() {
    return world.body(table.bodyB(row));
  }

  /**
   * Whether one of the shapes is a sensor: it was entered or left, and nothing is pushed.
   *
   * @return true in {@code begin} and {@code end} of sensors; there are no points then
   */
  public boolean isSensor() {
    return table.sensor(row);
  }

  /**
   * The partner of one of the two bodies.
   *
   * @param body self or other
   * @return the one that it isn't
   */
  public Body<T> other(Body<T> body) {
    return isSelf(body) ? other() : self();
  }

  /**
   * Whether directions are seen from this body.
   *
   * @param body one of the two
   * @return true if it is {@link #self}; if false, turn the normal and the MTV around
   */
  public boolean isSelf(Body<T> body) {
    return self() == body;
  }

  /**
   * The touching shape of self, as it was given to {@link BodyDef#shape}.
   *
   * @return in the body frame
   */
  public Shape selfShape() {
    return self().shape(world.dynamics().queries().shapeOf(table.partA(row)));
  }

  /**
   * What the touching shape of self is made of.
   *
   * @return its material
   */
  public Material selfMaterial() {
    return self().material(world.dynamics().queries().shapeOf(table.partA(row)));
  }

  /**
   * What the touching shape of the other is made of.
   *
   * @return its material
   */
  public Material otherMaterial() {
    return other().material(world.dynamics().queries().shapeOf(table.partB(row)));
  }

  /**
   * The touching shape of the other, as it was given to {@link BodyDef#shape}.
   *
   * @return in the body frame
   */
  public Shape otherShape() {
    return other().shape(world.dynamics().queries().shapeOf(table.partB(row)));
  }

  /**
   * Unit normal from self to other, x.
   *
   * @return -1 to 1
   */
  public float normalX() {
    return table.normalX(row);
  }

  /**
   * Unit normal from self to other, y.
   *
   * @return -1 to 1
   */
  public float normalY() {
    return table.normalY(row);
  }

  /**
   * How deep the shapes overlap along the normal.
   *
   * @return m; 0 if they are merely close
   */
  public float depth() {
    float least = 0;
    for (int i = 0; i < pointCount(); i++) {
      least = Math.min(least, table.separation(row, i));
    }
    return 0 - least;
  }

  /**
   * Minimum translation vector: moves self out of other.
   *
   * @return x, m; zero if the shapes are merely close, see {@link #normalX} for the direction
   */
  public float mtvX() {
    return -depth() * normalX();
  }

  /**
   * Minimum translation vector: moves self out of other.
   *
   * @return y, m
   */
  public float mtvY() {
    return -depth() * normalY();
  }

  /**
   * The number of contact points.
   *
   * @return 1 or 2; 0 when a collision ended
   */
  public int pointCount() {
    return table.points(row);
  }

  /**
   * A contact point, midway between the surfaces.
   *
   * @param i below {@link #pointCount}
   * @return x, m, world
   */
  public float pointX(int i) {
    return self().centerX() + table.pointX(row, check(i));
  }

  /**
   * A contact point, midway between the surfaces.
   *
   * @param i below {@link #pointCount}
   * @return y, m, world
   */
  public float pointY(int i) {
    return self().centerY() + table.pointY(row, check(i));
  }

  /**
   * Gap between the surfaces at a point.
   *
   * @param i below {@link #pointCount}
   * @return m, negative when they overlap
   */
  public float separation(int i) {
    return table.separation(row, check(i));
  }

  /**
   * Impulse of the step along the normal, on the other body; self receives the opposite.
   *
   * @param i below {@link #pointCount}
   * @return N s, not negative; 0 in begin and pre-solve
   */
  public float normalImpulse(int i) {
    return table.impulse(row, check(i));
  }

  /**
   * Impulse of the step along the normal, of all points together, on the other body.
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
   * How fast the bodies approached each other at the contact, along the normal, when the step
   * began.
   *
   * @return m/s, positive; 0 anywhere but in {@link CollisionListener#hit}
   */
  public float hitSpeed() {
    return hitSpeed;
  }

  /**
   * Where the impulse of the step went through: the mean of the points, weighted by their impulses.
   *
   * @return x, m, world
   */
  public float hitX() {
    float x = table.pointX(row, 0);
    return self().centerX() + x + secondShare() * (table.pointX(row, 1) - x);
  }

  /**
   * Where the impulse of the step went through: the mean of the points, weighted by their impulses.
   *
   * @return y, m, world
   */
  public float hitY() {
    float y = table.pointY(row, 0);
    return self().centerY() + y + secondShare() * (table.pointY(row, 1) - y);
  }

  /** What the second point has of the impulse. */
  private float secondShare() {
    float sum = impulse();
    return pointCount() > 1 && sum > 0 ? table.impulse(row, 1) / sum : 0;
  }

  /**
   * Impulse along the normal that the point carries over from the step before, with which this step
   * starts: above 0 in pre-solve when the contact has been holding something.
   *
   * @param i below {@link #pointCount}
   * @return N s per substep, not negative; 0 for a new point and after a veto
   */
  public float warmImpulse(int i) {
    return table.warmImpulse(row, check(i));
  }

  /**
   * Impulse of the step by friction, along the normal turned left, on the other body.
   *
   * @param i below {@link #pointCount}
   * @return N s
   */
  public float tangentImpulse(int i) {
    return table.slide(row, check(i));
  }

  /**
   * Mixed friction of the two shapes.
   *
   * @return Coulomb coefficient
   */
  public float friction() {
    return table.friction(row);
  }

  /**
   * Mixed restitution of the two shapes.
   *
   * @return speed after by speed before
   */
  public float restitution() {
    return table.restitution(row);
  }

  /**
   * Speed at which the two bodies part at a point, along the normal, now.
   *
   * @param i below {@link #pointCount}
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
