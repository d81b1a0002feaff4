package carom.physics;

import carom.physics.archive.Archive;
import carom.physics.settings.Constant;
import carom.physics.settings.MixingRule;
import carom.physics.settings.Settings;

/**
 * The constants of a world. A definition is immutable: each {@code with...} method returns a
 * changed copy, and throws {@link IllegalArgumentException} for a value that is not finite or out
 * of range. {@link Constant} lists the constants with defaults, ranges and what they do.
 *
 * <pre>
 *   new World&lt;&gt;(new WorldDef().withGravity(0, 0).withSubsteps(8))
 * </pre>
 *
 * <p>Two worlds behave alike only if all their constants are equal, so a server and its clients
 * share one definition. {@link World#redefine} changes most of them while a world runs.
 */
public final class WorldDef extends Settings {
  /** Makes a definition with gravity (0, -10) and the other defaults. */
  public WorldDef() {}

  /**
   * Returns a copy with this {@link Constant#GRAVITY_X} and {@link Constant#GRAVITY_Y}, -1e4..1e4
   * m/s^2; default (0, -10).
   */
  public WorldDef withGravity(float x, float y) {
    return with(Constant.GRAVITY_X, x).with(Constant.GRAVITY_Y, y);
  }

  /** Returns a copy with this number of {@link Constant#SUBSTEPS}, 1..32; default 4. */
  public WorldDef withSubsteps(int count) {
    return with(Constant.SUBSTEPS, count);
  }

  /** Returns a copy with this {@link Constant#CONTACT_HERTZ}, 1..1000 1/s; default 34. */
  public WorldDef withContactHertz(float hertz) {
    return with(Constant.CONTACT_HERTZ, hertz);
  }

  /** Returns a copy with this {@link Constant#CONTACT_DAMPING_RATIO}, 0.1..100; default 10. */
  public WorldDef withContactDampingRatio(float ratio) {
    return with(Constant.CONTACT_DAMPING_RATIO, ratio);
  }

  /** Returns a copy with this {@link Constant#RESTITUTION_THRESHOLD}, 0..1e5 m/s; default 1. */
  public WorldDef withRestitutionThreshold(float speed) {
    return with(Constant.RESTITUTION_THRESHOLD, speed);
  }

  /** Returns a copy with this {@link Constant#MAX_PUSH_SPEED}, 0..1000 m/s; default 3. */
  public WorldDef withMaxPushSpeed(float speed) {
    return with(Constant.MAX_PUSH_SPEED, speed);
  }

  /** Returns a copy with this {@link Constant#SLOP}, 0..1 m; default 0.002. */
  public WorldDef withSlop(float metres) {
    return with(Constant.SLOP, metres);
  }

  /** Returns a copy with this {@link Constant#SPECULATIVE_DISTANCE}, 0..1 m; default 0.02. */
  public WorldDef withSpeculativeDistance(float metres) {
    return with(Constant.SPECULATIVE_DISTANCE, metres);
  }

  /** Returns a copy with this {@link Constant#AABB_MARGIN}, 0..10 m; default 0.05. */
  public WorldDef withAabbMargin(float metres) {
    return with(Constant.AABB_MARGIN, metres);
  }

  /** Returns a copy with this {@link Constant#MAX_SPEED}, 1..1e5 m/s; default 2000. */
  public WorldDef withMaxSpeed(float speed) {
    return with(Constant.MAX_SPEED, speed);
  }

  /** Returns a copy with this {@link Constant#MAX_ANGULAR_SPEED}, 1..1e5 rad/s; default 250. */
  public WorldDef withMaxAngularSpeed(float speed) {
    return with(Constant.MAX_ANGULAR_SPEED, speed);
  }

  /** Returns a copy with this {@link Constant#JOINT_HERTZ}, 1..1000 1/s; default 60. */
  public WorldDef withJointHertz(float hertz) {
    return with(Constant.JOINT_HERTZ, hertz);
  }

  /** Returns a copy with this {@link Constant#JOINT_DAMPING_RATIO}, 0.1..100; default 5. */
  public WorldDef withJointDampingRatio(float ratio) {
    return with(Constant.JOINT_DAMPING_RATIO, ratio);
  }

  /**
   * Returns a copy in which bodies at rest fall asleep or not, see {@link Constant#SLEEPING};
   * default true.
   */
  public WorldDef withSleeping(boolean allowed) {
    return with(Constant.SLEEPING, allowed ? 1 : 0);
  }

  /** Returns a copy with this {@link Constant#SLEEP_SPEED}, 0..1000 m/s; default 0.05. */
  public WorldDef withSleepSpeed(float speed) {
    return with(Constant.SLEEP_SPEED, speed);
  }

  /** Returns a copy with this {@link Constant#SLEEP_DELAY}, 0.001..1000 s; default 0.5. */
  public WorldDef withSleepDelay(float seconds) {
    return with(Constant.SLEEP_DELAY, seconds);
  }

  /** Returns a copy with {@link Constant#CONTINUOUS} collision, or without; default true. */
  public WorldDef withContinuous(boolean allowed) {
    return with(Constant.CONTINUOUS, allowed ? 1 : 0);
  }

  /** Returns a copy with this {@link Constant#HIT_SPEED}, 0..1e5 m/s; default 1. */
  public WorldDef withHitSpeed(float speed) {
    return with(Constant.HIT_SPEED, speed);
  }

  /**
   * Returns a copy with this way in which velocities and positions advance. The solver is made for
   * the default, {@link Integrator#SYMPLECTIC_EULER}.
   */
  public WorldDef withIntegrator(Integrator integrator) {
    return with(Constant.INTEGRATOR, integrator);
  }

  /** Returns how velocities and positions advance. */
  public Integrator integrator() {
    return explicitEuler() ? Integrator.EXPLICIT_EULER : Integrator.SYMPLECTIC_EULER;
  }

  /**
   * Returns a copy in which the friction of two shapes is mixed by this rule, unless one of their
   * materials has its own; default {@link MixingRule#GEOMETRIC_MEAN}.
   */
  public WorldDef withFrictionMixing(MixingRule rule) {
    return with(Constant.FRICTION_MIXING, rule);
  }

  /**
   * Returns a copy in which the restitution of two shapes is mixed by this rule, unless one of
   * their materials has its own; default {@link MixingRule#MAX}.
   */
  public WorldDef withRestitutionMixing(MixingRule rule) {
    return with(Constant.RESTITUTION_MIXING, rule);
  }

  private WorldDef with(Constant constant, Enum<?> choice) {
    if (choice == null) {
      throw new IllegalArgumentException(constant.label() + "=null; choose one");
    }
    return with(constant, choice.ordinal());
  }

  private WorldDef with(Constant constant, float value) {
    WorldDef copy = (WorldDef) copy();
    copy.set(constant, value);
    return copy;
  }

  /** Returns a copy for the stages of one world. */
  Settings live() {
    return copy();
  }

  /** Returns a hash of all constants. */
  long hash() {
    return constantsHash();
  }

  /** Refuses to follow another definition in a running world if a constant differs that stays. */
  void checkFollows(WorldDef before) {
    refuseChanges(before);
  }

  /**
   * Passes constants through an archive.
   *
   * @param lasting whether those that a running world can't change, or all others
   * @return these constants, or with what was read
   */
  WorldDef passed(Archive a, boolean lasting) {
    WorldDef copy = (WorldDef) copy();
    copy.pass(a, lasting);
    return copy;
  }

  @Override
  protected String shown(Constant c) {
    return c == Constant.INTEGRATOR ? integrator().toString() : super.shown(c);
  }
}
