package carom.physics;

import carom.physics.math.Limits;
import java.util.function.Consumer;

/**
 * The constants of a world; immutable. Two worlds behave alike only if theirs are equal, so server
 * and client share one.
 *
 * @param gravityX acceleration of every dynamic body along x, m/s^2; default 0
 * @param gravityY along y, m/s^2; default -10, close to the earth's and easy to calculate with
 * @param substeps solver slices per step, 1 to 32; default 4. More make stacks stiffer and mass
 *     ratios safer, and cost proportionally
 * @param contactHertz stiffness of contacts as the frequency of a spring, 1/s; default 34. It is
 *     capped at a quarter of the substep rate, above which the spring can't be resolved. Softer
 *     contacts sink in: the rows of a pyramid of 100 by 15 mm at 30, by 12 mm at 34. Stiffer ones
 *     make wide piles tremble: that pyramid has 6 J at 30, 18 J at 34, hundreds at 54
 * @param contactDampingRatio how overdamped that spring is, 1 = critically; default 10, so that
 *     overlap is removed slowly and without a bounce
 * @param restitutionThreshold approach speed below which nothing bounces, m/s; default 1. Lower
 *     values let resting things hop
 * @param maxPushSpeed how fast overlap is pushed apart, m/s; default 3. Higher values make deep
 *     overlaps explode
 * @param slop overlap that is left alone, m; default 0.002. It keeps resting contacts closed
 * @param speculativeDistance gap below which a contact is already solved, m; default 0.02. It lets
 *     the solver stop bodies at the surface instead of behind it
 * @param aabbMargin how much larger the boxes in the broadphase are, m; default 0.05. Larger boxes
 *     are updated less often, but find more pairs; never changes a result
 * @param maxSpeed no body moves faster, m/s; default 2000, twice the speed of a rifle bullet. A
 *     safety net only: what keeps fast bodies from passing through others is {@code continuous}
 * @param maxAngularSpeed no body spins faster, rad/s; default 250, one radian per substep at 60
 *     ticks a second. Above two radians per substep the rotation can't be followed: there speeds
 *     end whatever this says
 * @param jointHertz how fast joints close what opened, as the frequency of a spring, 1/s; default
 *     60, capped at a quarter of the substep rate. It is also how far they yield: softer nets and
 *     cantilevers sag (at 30 twice as far as at 60)
 * @param jointDampingRatio how overdamped that spring is, 1 = critically; default 5. A net of
 *     10,000 that starts to fall opens by 1.05 m at 2 and by 0.64 m at 5, and welded beams come to
 *     rest
 * @param sleeping whether what rests is put to sleep, and costs nothing until it is disturbed;
 *     default true
 * @param sleepSpeed a body is at rest while no point of it moves faster, m/s; default 0.05. Higher
 *     values freeze slow motion, lower ones let piles tremble on for longer
 * @param sleepDelay how long all bodies that hold each other must be at rest to fall asleep, s;
 *     default 0.5, so that what turns round slowly isn't stopped there
 * @param continuous whether fast bodies are stopped at what they would pass through within a step,
 *     see {@link BodyDef#bullet}; default true. Costs next to nothing while nothing is fast; worlds
 *     without thin walls or fast bodies can do without
 * @param hitSpeed approach speed above which {@link CollisionListener#hit} is called, m/s; default
 *     1: what is worth a sound. Never changes a result
 * @param integrator how velocities and positions advance; default {@link
 *     Integrator#SYMPLECTIC_EULER}, for which everything else is made
 */
public record WorldDef(
    float gravityX,
    float gravityY,
    int substeps,
    float contactHertz,
    float contactDampingRatio,
    float restitutionThreshold,
    float maxPushSpeed,
    float slop,
    float speculativeDistance,
    float aabbMargin,
    float maxSpeed,
    float maxAngularSpeed,
    float jointHertz,
    float jointDampingRatio,
    boolean sleeping,
    float sleepSpeed,
    float sleepDelay,
    boolean continuous,
    float hitSpeed,
    Integrator integrator) {

  /** Gravity (0, -10) and the defaults. */
  public WorldDef() {
    this(
        0,
        -10,
        4,
        34,
        10,
        1,
        3,
        0.002f,
        0.02f,
        0.05f,
        2000,
        250,
        60,
        5,
        true,
        0.05f,
        0.5f,
        true,
        1,
        Integrator.SYMPLECTIC_EULER);
  }

  /**
   * Checks the ranges.
   *
   * @throws IllegalArgumentException naming the value that is not finite or out of range
   */
  public WorldDef {
    Limits.range("gravityX", gravityX, -1e4f, 1e4f);
    Limits.range("gravityY", gravityY, -1e4f, 1e4f);
    Limits.range("substeps", substeps, 1, 32);
    Limits.range("contactHertz", contactHertz, 1, 1000);
    Limits.range("contactDampingRatio", contactDampingRatio, 0.1f, 100);
    Limits.range("restitutionThreshold", restitutionThreshold, 0, 1e5f);
    Limits.range("maxPushSpeed", maxPushSpeed, 0, 1e3f);
    Limits.range("slop", slop, 0, 1);
    Limits.range("speculativeDistance", speculativeDistance, 0, 1);
    Limits.range("aabbMargin", aabbMargin, 0, 10);
    Limits.range("maxSpeed", maxSpeed, 1, 1e5f);
    Limits.range("maxAngularSpeed", maxAngularSpeed, 1, 1e5f);
    Limits.range("jointHertz", jointHertz, 1, 1000);
    Limits.range("jointDampingRatio", jointDampingRatio, 0.1f, 100);
    Limits.range("sleepSpeed", sleepSpeed, 0, 1e3f);
    Limits.range("sleepDelay", sleepDelay, 1e-3f, 1e3f);
    Limits.range("hitSpeed", hitSpeed, 0, 1e5f);
    if (integrator == null) {
      throw new IllegalArgumentException("integrator=null; choose one of Integrator's");
    }
  }

  /**
   * The same with another gravity.
   *
   * @param x m/s^2
   * @param y m/s^2, negative is down
   * @return a changed copy
   */
  public WorldDef withGravity(float x, float y) {
    return with(
        d -> {
          d.gravityX = x;
          d.gravityY = y;
        });
  }

  /**
   * The same with another {@link #substeps}.
   *
   * @param value slices per step
   * @return a changed copy
   */
  public WorldDef withSubsteps(int value) {
    return with(d -> d.substeps = value);
  }

  /**
   * The same with another {@link #contactHertz}.
   *
   * @param value 1/s
   * @return a changed copy
   */
  public WorldDef withContactHertz(float value) {
    return with(d -> d.contactHertz = value);
  }

  /**
   * The same with another {@link #contactDampingRatio}.
   *
   * @param value 1 = critical
   * @return a changed copy
   */
  public WorldDef withContactDampingRatio(float value) {
    return with(d -> d.contactDampingRatio = value);
  }

  /**
   * The same with another {@link #restitutionThreshold}.
   *
   * @param value m/s
   * @return a changed copy
   */
  public WorldDef withRestitutionThreshold(float value) {
    return with(d -> d.restitutionThreshold = value);
  }

  /**
   * The same with another {@link #maxPushSpeed}.
   *
   * @param value m/s
   * @return a changed copy
   */
  public WorldDef withMaxPushSpeed(float value) {
    return with(d -> d.maxPushSpeed = value);
  }

  /**
   * The same with another {@link #slop}.
   *
   * @param value m
   * @return a changed copy
   */
  public WorldDef withSlop(float value) {
    return with(d -> d.slop = value);
  }

  /**
   * The same with another {@link #speculativeDistance}.
   *
   * @param value m
   * @return a changed copy
   */
  public WorldDef withSpeculativeDistance(float value) {
    return with(d -> d.speculativeDistance = value);
  }

  /**
   * The same with another {@link #aabbMargin}.
   *
   * @param value m
   * @return a changed copy
   */
  public WorldDef withAabbMargin(float value) {
    return with(d -> d.aabbMargin = value);
  }

  /**
   * The same with another {@link #maxSpeed}.
   *
   * @param value m/s
   * @return a changed copy
   */
  public WorldDef withMaxSpeed(float value) {
    return with(d -> d.maxSpeed = value);
  }

  /**
   * The same with another {@link #maxAngularSpeed}.
   *
   * @param value rad/s
   * @return a changed copy
   */
  public WorldDef withMaxAngularSpeed(float value) {
    return with(d -> d.maxAngularSpeed = value);
  }

  /**
   * The same with another {@link #jointHertz}.
   *
   * @param value 1/s
   * @return a changed copy
   */
  public WorldDef withJointHertz(float value) {
    return with(d -> d.jointHertz = value);
  }

  /**
   * The same with another {@link #jointDampingRatio}.
   *
   * @param value 1 = critical
   * @return a changed copy
   */
  public WorldDef withJointDampingRatio(float value) {
    return with(d -> d.jointDampingRatio = value);
  }

  /**
   * The same with another {@link #sleeping}.
   *
   * @param value false to keep everything awake
   * @return a changed copy
   */
  public WorldDef withSleeping(boolean value) {
    return with(d -> d.sleeping = value);
  }

  /**
   * The same with another {@link #sleepSpeed}.
   *
   * @param value m/s
   * @return a changed copy
   */
  public WorldDef withSleepSpeed(float value) {
    return with(d -> d.sleepSpeed = value);
  }

  /**
   * The same with another {@link #sleepDelay}.
   *
   * @param value s
   * @return a changed copy
   */
  public WorldDef withSleepDelay(float value) {
    return with(d -> d.sleepDelay = value);
  }

  /**
   * The same with another {@link #continuous}.
   *
   * @param value whether fast bodies are stopped at what they would pass through
   * @return a changed copy
   */
  public WorldDef withContinuous(boolean value) {
    return with(d -> d.continuous = value);
  }

  /**
   * The same with another {@link #hitSpeed}.
   *
   * @param value m/s
   * @return a changed copy
   */
  public WorldDef withHitSpeed(float value) {
    return with(d -> d.hitSpeed = value);
  }

  /**
   * The same with another {@link #integrator}.
   *
   * @param value how velocities and positions advance
   * @return a changed copy
   */
  public WorldDef withIntegrator(Integrator value) {
    return with(d -> d.integrator = value);
  }

  private WorldDef with(Consumer<Draft> change) {
    Draft draft = new Draft(this);
    change.accept(draft);
    return draft.build();
  }

  /** The settings as variables, so that each {@code with...} method names just its own. */
  private static final class Draft {
    private float gravityX;
    private float gravityY;
    private int substeps;
    private float contactHertz;
    private float contactDampingRatio;
    private float restitutionThreshold;
    private float maxPushSpeed;
    private float slop;
    private float speculativeDistance;
    private float aabbMargin;
    private float maxSpeed;
    private float maxAngularSpeed;
    private float jointHertz;
    private float jointDampingRatio;
    private boolean sleeping;
    private float sleepSpeed;
    private float sleepDelay;
    private boolean continuous;
    private float hitSpeed;
    private Integrator integrator;

    Draft(WorldDef from) {
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
      integrator = from.integrator;
    }

    WorldDef build() {
      return new WorldDef(
          gravityX,
          gravityY,
          substeps,
          contactHertz,
          contactDampingRatio,
          restitutionThreshold,
          maxPushSpeed,
          slop,
          speculativeDistance,
          aabbMargin,
          maxSpeed,
          maxAngularSpeed,
          jointHertz,
          jointDampingRatio,
          sleeping,
          sleepSpeed,
          sleepDelay,
          continuous,
          hitSpeed,
          integrator);
    }
  }
}
