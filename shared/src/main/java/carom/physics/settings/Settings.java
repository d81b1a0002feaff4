package carom.physics.settings;

/**
 * The constants of a world, as the stages of a step read them.
 *
 * <p>This is the list of all constants with their defaults. {@code carom.physics.WorldDef}, the
 * only subclass, is what users see: it says what each constant does, checks its range and changes
 * copies. A definition never changes. The stages of a world share a copy of it, which {@linkplain
 * #take takes} another definition over between steps.
 */
public abstract class Settings implements Cloneable {
  protected float gravityX;
  protected float gravityY = -10;
  protected int substeps = 4;
  protected float contactHertz = 34;
  protected float contactDampingRatio = 10;
  protected float restitutionThreshold = 1;
  protected float maxPushSpeed = 3;
  protected float slop = 0.002f;
  protected float speculativeDistance = 0.02f;
  protected float aabbMargin = 0.05f;
  protected float maxSpeed = 2000;
  protected float maxAngularSpeed = 250;
  protected float jointHertz = 60;
  protected float jointDampingRatio = 5;
  protected boolean sleeping = true;
  protected float sleepSpeed = 0.05f;
  protected float sleepDelay = 0.5f;
  protected boolean continuous = true;
  protected float hitSpeed = 1;
  protected boolean explicitEuler;
  protected MixingRule frictionMixing = MixingRule.GEOMETRIC_MEAN;
  protected MixingRule restitutionMixing = MixingRule.MAX;

  /** Starts with the defaults. */
  protected Settings() {}

  /** Returns a copy, of the same class. */
  protected final Settings copy() {
    try {
      return (Settings) clone();
    } catch (CloneNotSupportedException e) {
      throw new AssertionError(e);
    }
  }

  /** Takes all constants of others over; for the copy of one world only, between steps. */
  public final void take(Settings from) {
    gravityX = from.gravityX;
    gravityY = from.gravityY;
    substeps = from.substeps;
    contactHertz = from.contactHertz;
    contactDampingRatio = from.contactDampingRatio;
    restitutionThreshold = from.restitutionThreshold;
    maxPushSpeed = from.maxPushSpeed;
    slop = from.slop;
    speculativeDistance = from.speculativeDistance;
    aabbMargin = from.aabbMargin;
    maxSpeed = from.maxSpeed;
    maxAngularSpeed = from.maxAngularSpeed;
    jointHertz = from.jointHertz;
    jointDampingRatio = from.jointDampingRatio;
    sleeping = from.sleeping;
    sleepSpeed = from.sleepSpeed;
    sleepDelay = from.sleepDelay;
    continuous = from.continuous;
    hitSpeed = from.hitSpeed;
    explicitEuler = from.explicitEuler;
    frictionMixing = from.frictionMixing;
    restitutionMixing = from.restitutionMixing;
  }

  /** Returns the acceleration of every dynamic body along x, m/s^2. */
  public final float gravityX() {
    return gravityX;
  }

  /** Returns the acceleration of every dynamic body along y, m/s^2. */
  public final float gravityY() {
    return gravityY;
  }

  /** Returns the number of solver substeps per step. */
  public final int substeps() {
    return substeps;
  }

  /** Returns the stiffness of contacts as the frequency of a spring, 1/s. */
  public final float contactHertz() {
    return contactHertz;
  }

  /** Returns the damping ratio of the spring of a contact, 1 = critical. */
  public final float contactDampingRatio() {
    return contactDampingRatio;
  }

  /** Returns the approach speed below which nothing bounces, m/s. */
  public final float restitutionThreshold() {
    return restitutionThreshold;
  }

  /** Returns the largest speed at which overlap is pushed apart, m/s. */
  public final float maxPushSpeed() {
    return maxPushSpeed;
  }

  /** Returns the overlap that the solver leaves alone, m. */
  public final float slop() {
    return slop;
  }

  /** Returns the gap below which a contact is already solved, m. */
  public final float speculativeDistance() {
    return speculativeDistance;
  }

  /** Returns how much the boxes in the broadphase are enlarged on each side, m. */
  public final float aabbMargin() {
    return aabbMargin;
  }

  /** Returns the largest speed of a body, m/s. */
  public final float maxSpeed() {
    return maxSpeed;
  }

  /** Returns the largest angular speed of a body, rad/s. */
  public final float maxAngularSpeed() {
    return maxAngularSpeed;
  }

  /** Returns the stiffness of joints as the frequency of a spring, 1/s. */
  public final float jointHertz() {
    return jointHertz;
  }

  /** Returns the damping ratio of the spring of a joint, 1 = critical. */
  public final float jointDampingRatio() {
    return jointDampingRatio;
  }

  /** Returns whether bodies at rest fall asleep. */
  public final boolean sleeping() {
    return sleeping;
  }

  /** Returns the speed below which a body is at rest, m/s. */
  public final float sleepSpeed() {
    return sleepSpeed;
  }

  /** Returns how long an island must be at rest to fall asleep, s. */
  public final float sleepDelay() {
    return sleepDelay;
  }

  /** Returns whether fast bodies are stopped at what they would pass through. */
  public final boolean continuous() {
    return continuous;
  }

  /** Returns the approach speed above which a hit is reported, m/s. */
  public final float hitSpeed() {
    return hitSpeed;
  }

  /** Returns whether positions advance by the old velocities, not the new ones. */
  public final boolean explicitEuler() {
    return explicitEuler;
  }

  /** Returns how the friction of two shapes without a rule of their own is mixed. */
  public final MixingRule frictionMixing() {
    return frictionMixing;
  }

  /** Returns how the restitution of two shapes without a rule of their own is mixed. */
  public final MixingRule restitutionMixing() {
    return restitutionMixing;
  }
}
