package carom.physics;

import carom.physics.archive.Archive;
import carom.physics.math.Limits;
import carom.physics.math.StateHash;
import carom.physics.settings.MixingRule;
import carom.physics.settings.Settings;
import java.util.function.Consumer;

/**
 * The constants of a world. A definition is immutable: each {@code with...} method returns a
 * changed copy, and throws {@link IllegalArgumentException} for a value that is not finite or out
 * of range.
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
   * Returns a copy with this acceleration of every dynamic body, m/s^2, within 1e4. The default is
   * (0, -10): close to the earth's, and easy to calculate with.
   */
  public WorldDef withGravity(float x, float y) {
    return with(
        d -> {
          d.gravityX = Limits.range("gravityX", x, -1e4f, 1e4f);
          d.gravityY = Limits.range("gravityY", y, -1e4f, 1e4f);
        });
  }

  /**
   * Returns a copy with this many solver substeps per step, 1..32; default 4. More substeps make
   * stacks stiffer and large mass ratios safer, and cost proportionally.
   */
  public WorldDef withSubsteps(int count) {
    return with(d -> d.substeps = (int) Limits.range("substeps", count, 1, 32));
  }

  /**
   * Returns a copy with this stiffness of contacts, as the frequency of a spring, 1..1000 1/s;
   * default 34. The solver caps it at a quarter of the substep rate, above which the spring can't
   * be resolved.
   *
   * <p>Softer contacts sink in: the rows of a pyramid of 100 by 15 mm at 30, by 12 mm at 34.
   * Stiffer ones make wide piles tremble: that pyramid has 6 J at 30, 18 J at 34, hundreds at 54.
   */
  public WorldDef withContactHertz(float hertz) {
    return with(d -> d.contactHertz = Limits.range("contactHertz", hertz, 1, 1000));
  }

  /**
   * Returns a copy with this damping ratio of the spring of a contact, 0.1..100, 1 = critical. The
   * default 10 removes overlap slowly and without a bounce.
   */
  public WorldDef withContactDampingRatio(float ratio) {
    return with(d -> d.contactDampingRatio = Limits.range("contactDampingRatio", ratio, 0.1f, 100));
  }

  /**
   * Returns a copy with this approach speed below which nothing bounces, 0..1e5 m/s; default 1.
   * Lower values let resting bodies hop.
   */
  public WorldDef withRestitutionThreshold(float speed) {
    return with(d -> d.restitutionThreshold = Limits.range("restitutionThreshold", speed, 0, 1e5f));
  }

  /**
   * Returns a copy with this largest speed at which overlap is pushed apart, 0..1000 m/s; default
   * 3. Higher values make deep overlaps explode.
   */
  public WorldDef withMaxPushSpeed(float speed) {
    return with(d -> d.maxPushSpeed = Limits.range("maxPushSpeed", speed, 0, 1e3f));
  }

  /**
   * Returns a copy with this overlap that the solver leaves alone, 0..1 m; default 0.002. It keeps
   * resting contacts closed. It is also how well pieces of a ground must fit to count as one
   * surface; there, less than 0.0001 counts as that.
   */
  public WorldDef withSlop(float metres) {
    return with(d -> d.slop = Limits.range("slop", metres, 0, 1));
  }

  /**
   * Returns a copy with this gap below which a contact is already solved, 0..1 m; default 0.02. It
   * lets the solver stop bodies at the surface instead of behind it.
   */
  public WorldDef withSpeculativeDistance(float metres) {
    return with(d -> d.speculativeDistance = Limits.range("speculativeDistance", metres, 0, 1));
  }

  /**
   * Returns a copy in which the boxes of the broadphase are larger by this margin, 0..10 m; default
   * 0.05. Larger boxes are updated less often, but find more pairs. It never changes a result.
   */
  public WorldDef withAabbMargin(float metres) {
    return with(d -> d.aabbMargin = Limits.range("aabbMargin", metres, 0, 10));
  }

  /**
   * Returns a copy with this largest speed of a body, 1..1e5 m/s; default 2000, twice the speed of
   * a rifle bullet. It is a safety net only: {@link #withContinuous} keeps fast bodies from passing
   * through others.
   */
  public WorldDef withMaxSpeed(float speed) {
    return with(d -> d.maxSpeed = Limits.range("maxSpeed", speed, 1, 1e5f));
  }

  /**
   * Returns a copy with this largest angular speed of a body, 1..1e5 rad/s; default 250, one radian
   * per substep at 60 ticks a second. Above two radians per substep the rotation can't be followed:
   * angular speeds end there whatever this value is.
   */
  public WorldDef withMaxAngularSpeed(float speed) {
    return with(d -> d.maxAngularSpeed = Limits.range("maxAngularSpeed", speed, 1, 1e5f));
  }

  /**
   * Returns a copy with this stiffness of joints, as the frequency of a spring, 1..1000 1/s;
   * default 60. The solver caps it at a quarter of the substep rate. Softer joints close more
   * slowly and stretch further: nets and cantilevers sag twice as far at 30 as at 60.
   */
  public WorldDef withJointHertz(float hertz) {
    return with(d -> d.jointHertz = Limits.range("jointHertz", hertz, 1, 1000));
  }

  /**
   * Returns a copy with this damping ratio of the spring of a joint, 0.1..100, 1 = critical;
   * default 5. A net of 10,000 that starts to fall opens by 1.05 m at 2 and by 0.64 m at 5, and
   * welded beams come to rest.
   */
  public WorldDef withJointDampingRatio(float ratio) {
    return with(d -> d.jointDampingRatio = Limits.range("jointDampingRatio", ratio, 0.1f, 100));
  }

  /**
   * Returns a copy in which bodies at rest fall asleep or not; default true. A sleeping body costs
   * nothing until it is disturbed.
   */
  public WorldDef withSleeping(boolean allowed) {
    return with(d -> d.sleeping = allowed);
  }

  /**
   * Returns a copy in which a body is at rest while no point of it moves faster than this, 0..1000
   * m/s; default 0.05. Higher values freeze slow motion, lower ones let piles tremble for longer. A
   * body may have a speed of its own, {@link BodyDef#sleepSpeed}.
   */
  public WorldDef withSleepSpeed(float speed) {
    return with(d -> d.sleepSpeed = Limits.range("sleepSpeed", speed, 0, Limits.MAX_SLEEP_SPEED));
  }

  /**
   * Returns a copy in which all bodies of an island must be at rest for this long to fall asleep,
   * 0.001..1000 s. The default 0.5 doesn't stop a body at the turning point of a slow motion.
   */
  public WorldDef withSleepDelay(float seconds) {
    return with(d -> d.sleepDelay = Limits.range("sleepDelay", seconds, 1e-3f, 1e3f));
  }

  /**
   * Returns a copy in which fast bodies are stopped at what they would pass through within a step,
   * or not; default true. See {@link BodyDef#bullet}. It costs next to nothing while nothing is
   * fast. Worlds without thin walls or fast bodies can do without.
   */
  public WorldDef withContinuous(boolean allowed) {
    return with(d -> d.continuous = allowed);
  }

  /**
   * Returns a copy with this approach speed above which {@link CollisionListener#hit} is called,
   * 0..1e5 m/s; default 1, an impact worth a sound. It never changes a result.
   */
  public WorldDef withHitSpeed(float speed) {
    return with(d -> d.hitSpeed = Limits.range("hitSpeed", speed, 0, 1e5f));
  }

  /**
   * Returns a copy with this way in which velocities and positions advance. The solver is made for
   * the default, {@link Integrator#SYMPLECTIC_EULER}.
   */
  public WorldDef withIntegrator(Integrator integrator) {
    if (integrator == null) {
      throw new IllegalArgumentException("integrator=null; choose one of Integrator's");
    }
    return with(d -> d.explicitEuler = integrator == Integrator.EXPLICIT_EULER);
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
    return with(d -> d.frictionMixing = checked("frictionMixing", rule));
  }

  /**
   * Returns a copy in which the restitution of two shapes is mixed by this rule, unless one of
   * their materials has its own; default {@link MixingRule#MAX}.
   */
  public WorldDef withRestitutionMixing(MixingRule rule) {
    return with(d -> d.restitutionMixing = checked("restitutionMixing", rule));
  }

  private static MixingRule checked(String name, MixingRule rule) {
    if (rule == null) {
      throw new IllegalArgumentException(name + "=null; choose one of MixingRule's");
    }
    return rule;
  }

  /** Returns a copy for the stages of one world. */
  Settings live() {
    return copy();
  }

  /** Returns a hash of all constants. */
  long hash() {
    long h = StateHash.mix(StateHash.SEED, gravityX(), gravityY());
    h = StateHash.mix(h, substeps());
    h = StateHash.mix(h, contactHertz(), contactDampingRatio());
    h = StateHash.mix(h, restitutionThreshold(), maxPushSpeed());
    h = StateHash.mix(h, slop(), speculativeDistance());
    h = StateHash.mix(h, aabbMargin(), hitSpeed());
    h = StateHash.mix(h, maxSpeed(), maxAngularSpeed());
    h = StateHash.mix(h, jointHertz(), jointDampingRatio());
    h = StateHash.mix(h, sleepSpeed(), sleepDelay());
    h = StateHash.mix(h, (sleeping() ? 1 : 0) | (continuous() ? 2 : 0));
    if (frictionMixing() != MixingRule.GEOMETRIC_MEAN || restitutionMixing() != MixingRule.MAX) {
      h = StateHash.mix(h, frictionMixing().ordinal() << 4 | restitutionMixing().ordinal());
    }
    return StateHash.finish(StateHash.mix(h, integrator().ordinal()));
  }

  /** Refuses to follow another definition in a running world, if a constant differs that stays. */
  void checkFollows(WorldDef before) {
    refuseChange(
        "substeps",
        substeps(),
        before.substeps(),
        "contacts and joints start with the impulses of a substep of that length");
    refuseChange(
        "speculativeDistance",
        speculativeDistance(),
        before.speculativeDistance(),
        "the boxes and contacts that the world holds were measured with it");
    refuseChange(
        "integrator", integrator(), before.integrator(), "both give velocities another meaning");
    String mixed = "the contacts that the world holds were mixed by it";
    refuseChange("frictionMixing", frictionMixing(), before.frictionMixing(), mixed);
    refuseChange("restitutionMixing", restitutionMixing(), before.restitutionMixing(), mixed);
  }

  private static void refuseChange(String name, Object now, Object before, String why) {
    if (!now.equals(before)) {
      throw new IllegalArgumentException(
          name
              + "="
              + now
              + " differs from "
              + before
              + " and can't be changed while the world runs, because "
              + why
              + "; make a new World");
    }
  }

  /**
   * Passes the constants that a running world may change through an archive.
   *
   * @return these constants, or with what was read
   */
  WorldDef passChangeable(Archive a) {
    float most = Float.MAX_VALUE;
    return withGravity(
            a.number("gravity x", gravityX(), -most, most),
            a.number("gravity y", gravityY(), -most, most))
        .withContactHertz(a.number("contact hertz", contactHertz(), 0, most))
        .withContactDampingRatio(a.number("contact damping", contactDampingRatio(), 0, most))
        .withRestitutionThreshold(
            a.number("restitution threshold", restitutionThreshold(), 0, most))
        .withMaxPushSpeed(a.number("push speed", maxPushSpeed(), 0, most))
        .withSlop(a.number("slop", slop(), 0, most))
        .withAabbMargin(a.number("margin", aabbMargin(), 0, most))
        .withMaxSpeed(a.number("speed limit", maxSpeed(), 0, most))
        .withMaxAngularSpeed(a.number("angular speed limit", maxAngularSpeed(), 0, most))
        .withJointHertz(a.number("joint hertz", jointHertz(), 0, most))
        .withJointDampingRatio(a.number("joint damping", jointDampingRatio(), 0, most))
        .withSleeping(a.flag("sleeping", sleeping()))
        .withSleepSpeed(a.number("sleep speed", sleepSpeed(), 0, most))
        .withSleepDelay(a.number("sleep delay", sleepDelay(), 0, most))
        .withContinuous(a.flag("continuous", continuous()))
        .withHitSpeed(a.number("hit speed", hitSpeed(), 0, most));
  }

  private WorldDef with(Consumer<WorldDef> change) {
    WorldDef copy = (WorldDef) copy();
    change.accept(copy);
    return copy;
  }
}
