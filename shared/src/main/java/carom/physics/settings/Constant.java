package carom.physics.settings;

import carom.physics.math.Limits;

/**
 * The constants of a world. A row is all there is to a constant: its name, default and range, what
 * it does, and whether a running world may change it. Storage, checks, hash and archive follow from
 * the rows, in their order.
 */
public enum Constant {
  /** Acceleration of every dynamic body along x, m/s^2. */
  GRAVITY_X("gravityX", 0, -1e4f, 1e4f),

  /**
   * Acceleration of every dynamic body along y, m/s^2. The default is close to the earth's, and
   * easy to calculate with.
   */
  GRAVITY_Y("gravityY", -10, -1e4f, 1e4f),

  /**
   * Number of solver substeps per step. More make stacks stiffer and large mass ratios safer, and
   * cost proportionally.
   */
  SUBSTEPS(
      Kind.WHOLE,
      "substeps",
      4,
      1,
      32,
      "contacts and joints start with the impulses of a substep of that length"),

  /**
   * Stiffness of contacts, as the frequency of a spring, 1/s. The solver caps it at a quarter of
   * the substep rate, above which the spring can't be resolved.
   *
   * <p>Softer contacts sink in: the rows of a pyramid of 100 by 15 mm at 30, by 12 mm at 34.
   * Stiffer ones make wide piles tremble: that pyramid has 6 J at 30, 18 J at 34, hundreds at 54.
   */
  CONTACT_HERTZ("contactHertz", 34, 1, 1000),

  /**
   * Damping ratio of the spring of a contact, 1 = critical. The default removes overlap slowly and
   * without a bounce.
   */
  CONTACT_DAMPING_RATIO("contactDampingRatio", 10, 0.1f, 100),

  /** Approach speed below which nothing bounces, m/s. Lower values let resting bodies hop. */
  RESTITUTION_THRESHOLD("restitutionThreshold", 1, 0, 1e5f),

  /**
   * Largest speed at which overlap is pushed apart, m/s. Higher ones make deep overlaps explode.
   */
  MAX_PUSH_SPEED("maxPushSpeed", 3, 0, 1e3f),

  /**
   * Overlap that the solver leaves alone, m. It keeps resting contacts closed. It is also how well
   * pieces of a ground must fit to count as one surface; there, less than 0.0001 counts as that.
   */
  SLOP("slop", 0.002f, 0, 1),

  /**
   * Gap below which a contact is already solved, m. It lets the solver stop bodies at the surface
   * instead of behind it.
   */
  SPECULATIVE_DISTANCE(
      Kind.NUMBER,
      "speculativeDistance",
      0.02f,
      0,
      1,
      "the boxes and contacts that the world holds were measured with it"),

  /**
   * Margin by which the boxes of the broadphase are larger on each side, m. Larger boxes are
   * updated less often, but find more pairs. It never changes a result.
   */
  AABB_MARGIN("aabbMargin", 0.05f, 0, 10),

  /**
   * Largest speed of a body, m/s; by default twice the speed of a rifle bullet. It is a safety net
   * only: {@link #CONTINUOUS} keeps fast bodies from passing through others.
   */
  MAX_SPEED("maxSpeed", 2000, 1, 1e5f),

  /**
   * Largest angular speed of a body, rad/s; by default one radian per substep at 60 ticks a second.
   * Above two radians per substep the rotation can't be followed: angular speeds end there for
   * every value.
   */
  MAX_ANGULAR_SPEED("maxAngularSpeed", 250, 1, 1e5f),

  /**
   * Stiffness of joints, as the frequency of a spring, 1/s. The solver caps it at a quarter of the
   * substep rate. Softer joints close more slowly and stretch further: nets and cantilevers sag
   * twice as far at 30 as at 60.
   */
  JOINT_HERTZ("jointHertz", 60, 1, 1000),

  /**
   * Damping ratio of the spring of a joint, 1 = critical. A net of 10,000 that starts to fall opens
   * by 1.05 m at 2 and by 0.64 m at 5, and welded beams come to rest.
   */
  JOINT_DAMPING_RATIO("jointDampingRatio", 5, 0.1f, 100),

  /**
   * Switch for sleep: bodies at rest fall asleep. A sleeping body costs nothing until it is
   * disturbed.
   */
  SLEEPING("sleeping", true),

  /**
   * Speed below which a body is at rest, m/s: no point of it moves faster. Higher values freeze
   * slow motion, lower ones let piles tremble for longer. A body may have a speed of its own.
   */
  SLEEP_SPEED("sleepSpeed", 0.05f, 0, Limits.MAX_SLEEP_SPEED),

  /**
   * Time for which all bodies of an island must be at rest to fall asleep, s. The default doesn't
   * stop a body at the turning point of a slow motion.
   */
  SLEEP_DELAY("sleepDelay", 0.5f, 1e-3f, 1e3f),

  /**
   * Switch for continuous collision: fast bodies are stopped at what they would pass through within
   * a step. It costs next to nothing while nothing is fast. Worlds without thin walls or fast
   * bodies can do without.
   */
  CONTINUOUS("continuous", true),

  /**
   * Approach speed above which a hit is reported, m/s; by default an impact worth a sound. It never
   * changes a result.
   */
  HIT_SPEED("hitSpeed", 1, 0, 1e5f),

  /** Way in which velocities and positions advance, as its place in the list of integrators. */
  INTEGRATOR(Kind.CHOICE, "integrator", 0, 0, 1, "both give velocities another meaning"),

  /** Rule by which the friction of two shapes without a rule of their own is mixed. */
  FRICTION_MIXING("frictionMixing", MixingRule.GEOMETRIC_MEAN),

  /** Rule by which the restitution of two shapes without a rule of their own is mixed. */
  RESTITUTION_MIXING("restitutionMixing", MixingRule.MAX);

  /** Meaning of the number of a constant. Floats hold all kinds exactly. */
  enum Kind {
    /** A real number. */
    NUMBER,
    /** A whole number. */
    WHOLE,
    /** 1 for true, 0 for false. */
    SWITCH,
    /** The place of a value in its list. */
    CHOICE
  }

  final Kind kind;
  final String label;
  final float initial;
  final float min;
  final float max;

  /** Reason why a running world can't change it, or null if it can. */
  final String lasting;

  Constant(Kind kind, String label, float initial, float min, float max, String lasting) {
    this.kind = kind;
    this.label = label;
    this.initial = initial;
    this.min = min;
    this.max = max;
    this.lasting = lasting;
  }

  Constant(String label, float initial, float min, float max) {
    this(Kind.NUMBER, label, initial, min, max, null);
  }

  Constant(String label, boolean initial) {
    this(Kind.SWITCH, label, initial ? 1 : 0, 0, 1, null);
  }

  Constant(String label, MixingRule initial) {
    this(
        Kind.CHOICE,
        label,
        initial.ordinal(),
        0,
        MixingRule.MAX.ordinal(),
        "the contacts that the world holds were mixed by it");
  }

  /** Returns its name, as that of the getter. */
  public String label() {
    return label;
  }

  /** Returns the least value that is allowed, in the unit of the constant; 0 for switches. */
  public float min() {
    return min;
  }

  /** Returns the largest value that is allowed, in the unit of the constant; 1 for switches. */
  public float max() {
    return max;
  }
}
