package carom.sim.entity;

import carom.physics.Collision;
import carom.physics.Material;
import carom.physics.effects.OneWay;

/**
 * Two entities that touch, as {@code Game.collision} and {@code Game.hit} see them. There is one
 * such object, which is reused for each call: don't keep it.
 *
 * <p>Self and other are in the order of the world's bodies; ask {@link #isSelf}. Directions are
 * seen from self.
 */
public final class Contact {
  private final OneWay<HostEntity> oneWay =
      new OneWay<>((body, shape) -> body.user().archetype().oneWay());
  private Collision<HostEntity> c;

  /** Creates the contact of a simulation. */
  public Contact() {}

  /** Shows what the engine tells now. */
  public Contact of(Collision<HostEntity> collision) {
    c = collision;
    return this;
  }

  /** Returns the engine's collision, for what runs a simulation. */
  public static Collision<HostEntity> engineOf(Contact contact) {
    return contact.c;
  }

  /** Returns the one of both that comes first in the world. */
  public Entity self() {
    return c.self().user();
  }

  /** Returns the other one. */
  public Entity other() {
    return c.other().user();
  }

  /** Returns the partner of one of the two. */
  public Entity other(Entity entity) {
    return isSelf(entity) ? other() : self();
  }

  /** Returns whether an entity is {@link #self}; if it is the other one, negate the normal. */
  public boolean isSelf(Entity entity) {
    return self() == entity;
  }

  /**
   * Returns whether the rule of one-way platforms lets the two collide: false while one of them
   * passes a platform from below. {@code Game.collision} answers this by default.
   */
  public boolean holdsOneWay() {
    return oneWay.preSolve(c);
  }

  /**
   * Returns whether this is a question of continuous collision: a fast body would be stopped here
   * within the step. The entities are at the place of the impact then, with the velocities of the
   * end of the step, and points may have a gap.
   */
  public boolean isSwept() {
    return c.isSwept();
  }

  /** Returns which of self's shapes touches, in the order of its archetype's. */
  public int selfShapeIndex() {
    return c.selfShapeIndex();
  }

  /** Returns which of other's shapes touches, in the order of its archetype's. */
  public int otherShapeIndex() {
    return c.otherShapeIndex();
  }

  /** Returns the material of self's shape. */
  public Material selfMaterial() {
    return c.selfMaterial();
  }

  /** Returns the material of other's shape. */
  public Material otherMaterial() {
    return c.otherMaterial();
  }

  /** Returns x of the unit normal from self to other: standing on other, it points down. */
  public float normalX() {
    return c.normalX();
  }

  /** Returns y of the unit normal from self to other: standing on other, it points down. */
  public float normalY() {
    return c.normalY();
  }

  /** Returns how deep the shapes overlap, m, not negative; 0 if they are merely close. */
  public float depth() {
    return c.depth();
  }

  /** Returns x of the minimum translation vector (MTV), which moves self out of other, m. */
  public float mtvX() {
    return c.mtvX();
  }

  /** Returns y of the minimum translation vector (MTV), which moves self out of other, m. */
  public float mtvY() {
    return c.mtvY();
  }

  /** Returns the number of contact points, 1 or 2. */
  public int pointCount() {
    return c.pointCount();
  }

  /** Returns x of a contact point, m, midway between the surfaces. */
  public float pointX(int i) {
    return c.pointX(i);
  }

  /** Returns y of a contact point, m, midway between the surfaces. */
  public float pointY(int i) {
    return c.pointY(i);
  }

  /**
   * Returns the speed at which the entities separate at a point, m/s; negative when they approach.
   */
  public float normalSpeed(int i) {
    return c.normalSpeed(i);
  }

  /**
   * Returns the impulse along the normal that a point carries over from the step before, N s per
   * substep. It is above 0 in {@code collision} if the contact carried a load.
   */
  public float warmImpulse(int i) {
    return c.warmImpulse(i);
  }

  /** Returns the impulse of the step on other, along the normal, N s; 0 in {@code collision}. */
  public float impulse() {
    return c.impulse();
  }

  /**
   * Returns the speed at which the entities approached each other, m/s; 0 outside of {@code hit}.
   */
  public float hitSpeed() {
    return c.hitSpeed();
  }

  /** Returns x of where the impulse of the step acted, m. */
  public float hitX() {
    return c.hitX();
  }

  /** Returns y of where the impulse of the step acted, m. */
  public float hitY() {
    return c.hitY();
  }

  /** Returns the friction of the contact, a Coulomb coefficient. */
  public float friction() {
    return c.friction();
  }

  /** Returns the ratio of the speed after a bounce to the speed before. */
  public float restitution() {
    return c.restitution();
  }

  /** Returns the tangent speed of the contact, m/s, see {@link #setTangentSpeed}. */
  public float tangentSpeed() {
    return c.tangentSpeed();
  }

  /**
   * Sets the friction of this contact for this step, a Coulomb coefficient, 0..100; in {@code
   * collision} only. In the next step it is that of the shapes again.
   */
  public void setFriction(float friction) {
    c.setFriction(friction);
  }

  /** Sets the restitution of this contact for this step, 0..2; in {@code collision} only. */
  public void setRestitution(float restitution) {
    c.setRestitution(restitution);
  }

  /**
   * Sets the tangent speed of this contact for this step, m/s; in {@code collision} only: a
   * conveyor belt that works only here or now. On a floor, a positive speed drives what lies on it
   * to the right.
   */
  public void setTangentSpeed(float speed) {
    c.setTangentSpeed(speed);
  }
}
