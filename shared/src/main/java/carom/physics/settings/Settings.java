package carom.physics.settings;

import carom.physics.archive.Archive;
import carom.physics.math.Limits;
import carom.physics.math.StateHash;
import java.util.ArrayList;
import java.util.List;

/**
 * The values of the {@linkplain Constant constants} of a world, as the stages of a step read them.
 *
 * <p>{@code carom.physics.WorldDef}, the only subclass, is what users see: it changes copies. A
 * definition never changes. The stages of a world share a copy of it, which {@linkplain #take
 * takes} another definition over between steps.
 */
public abstract class Settings implements Cloneable {
  private static final Constant[] CONSTANTS = Constant.values();
  private static final MixingRule[] RULES = MixingRule.values();
  private static final Constant[] HASHED = hashed();

  private float[] values = new float[CONSTANTS.length];

  /** Returns the order in which hashes have the constants: hits elsewhere than in archives. */
  private static Constant[] hashed() {
    List<Constant> all = new ArrayList<>(List.of(CONSTANTS));
    all.remove(Constant.HIT_SPEED);
    all.add(all.indexOf(Constant.AABB_MARGIN) + 1, Constant.HIT_SPEED);
    return all.toArray(new Constant[0]); // whose walk allocates nothing
  }

  /** Starts with the defaults. */
  protected Settings() {
    for (Constant c : CONSTANTS) {
      values[c.ordinal()] = c.initial;
    }
  }

  /** Returns a copy, of the same class. */
  protected final Settings copy() {
    try {
      Settings copy = (Settings) clone();
      copy.values = values.clone();
      return copy;
    } catch (CloneNotSupportedException e) {
      throw new AssertionError(e);
    }
  }

  /** Takes all constants of others over; for the copy of one world only, between steps. */
  public final void take(Settings from) {
    System.arraycopy(from.values, 0, values, 0, values.length);
  }

  /**
   * Sets a constant of a copy that isn't shared yet.
   *
   * @throws IllegalArgumentException if the value is NaN or out of range
   */
  protected final void set(Constant c, float value) {
    values[c.ordinal()] = Limits.range(c.label, value, c.min, c.max);
  }

  /** Returns the value of a constant. */
  private float value(Constant c) {
    return values[c.ordinal()];
  }

  /** Returns a hash of all constants. */
  protected final long constantsHash() {
    long h = StateHash.SEED;
    long switches = 0;
    int bit = 0;
    Constant first = null; // of a pair of numbers
    for (Constant c : HASHED) {
      switch (c.kind) {
        case WHOLE -> h = StateHash.mix(h, (long) value(c));
        case SWITCH -> switches |= (long) value(c) << bit++;
        case NUMBER -> {
          h = first == null ? h : StateHash.mix(h, value(first), value(c));
          first = first == null ? c : null;
        }
        default -> {} // below
      }
    }
    h = StateHash.mix(h, switches);
    if (frictionMixing() != MixingRule.GEOMETRIC_MEAN || restitutionMixing() != MixingRule.MAX) {
      h = StateHash.mix(h, frictionMixing().ordinal() << 4 | restitutionMixing().ordinal());
    }
    return StateHash.finish(StateHash.mix(h, (long) value(Constant.INTEGRATOR)));
  }

  /**
   * Refuses to follow others in a running world if a constant differs that stays.
   *
   * @throws IllegalArgumentException names the first
   */
  protected final void refuseChanges(Settings before) {
    for (Constant c : CONSTANTS) {
      if (c.lasting != null && value(c) != before.value(c)) {
        throw new IllegalArgumentException(
            c.label
                + "="
                + shown(c)
                + " differs from "
                + before.shown(c)
                + " and can't be changed while the world runs, because "
                + c.lasting
                + "; make a new World");
      }
    }
  }

  /** Returns the value of a constant for people. */
  protected String shown(Constant c) {
    return switch (c.kind) {
      case NUMBER -> String.valueOf(value(c));
      case WHOLE -> String.valueOf((int) value(c));
      case SWITCH -> String.valueOf(value(c) != 0);
      case CHOICE -> String.valueOf(RULES[(int) value(c)]);
    };
  }

  /**
   * Passes constants of a copy through an archive.
   *
   * @param lasting whether those that a running world can't change, or all others
   */
  protected final void pass(Archive a, boolean lasting) {
    for (Constant c : CONSTANTS) {
      if ((c.lasting != null) == lasting) {
        set(
            c,
            c.kind == Constant.Kind.NUMBER
                ? a.number(c.label, value(c), c.min, c.max)
                : a.integer(c.label, (int) value(c), (int) c.min, (int) c.max));
      }
    }
  }

  /** Returns the acceleration of every dynamic body along x, m/s^2. */
  public final float gravityX() {
    return value(Constant.GRAVITY_X);
  }

  /** Returns the acceleration of every dynamic body along y, m/s^2. */
  public final float gravityY() {
    return value(Constant.GRAVITY_Y);
  }

  /** Returns the number of solver substeps per step. */
  public final int substeps() {
    return (int) value(Constant.SUBSTEPS);
  }

  /** Returns the stiffness of contacts as the frequency of a spring, 1/s. */
  public final float contactHertz() {
    return value(Constant.CONTACT_HERTZ);
  }

  /** Returns the damping ratio of the spring of a contact, 1 = critical. */
  public final float contactDampingRatio() {
    return value(Constant.CONTACT_DAMPING_RATIO);
  }

  /** Returns the approach speed below which nothing bounces, m/s. */
  public final float restitutionThreshold() {
    return value(Constant.RESTITUTION_THRESHOLD);
  }

  /** Returns the largest speed at which overlap is pushed apart, m/s. */
  public final float maxPushSpeed() {
    return value(Constant.MAX_PUSH_SPEED);
  }

  /** Returns the overlap that the solver leaves alone, m. */
  public final float slop() {
    return value(Constant.SLOP);
  }

  /** Returns the gap below which a contact is already solved, m. */
  public final float speculativeDistance() {
    return value(Constant.SPECULATIVE_DISTANCE);
  }

  /** Returns how much the boxes in the broadphase are enlarged on each side, m. */
  public final float aabbMargin() {
    return value(Constant.AABB_MARGIN);
  }

  /** Returns the largest speed of a body, m/s. */
  public final float maxSpeed() {
    return value(Constant.MAX_SPEED);
  }

  /** Returns the largest angular speed of a body, rad/s. */
  public final float maxAngularSpeed() {
    return value(Constant.MAX_ANGULAR_SPEED);
  }

  /** Returns the stiffness of joints as the frequency of a spring, 1/s. */
  public final float jointHertz() {
    return value(Constant.JOINT_HERTZ);
  }

  /** Returns the damping ratio of the spring of a joint, 1 = critical. */
  public final float jointDampingRatio() {
    return value(Constant.JOINT_DAMPING_RATIO);
  }

  /** Returns whether bodies at rest fall asleep. */
  public final boolean sleeping() {
    return value(Constant.SLEEPING) != 0;
  }

  /** Returns the speed below which a body is at rest, m/s. */
  public final float sleepSpeed() {
    return value(Constant.SLEEP_SPEED);
  }

  /** Returns how long an island must be at rest to fall asleep, s. */
  public final float sleepDelay() {
    return value(Constant.SLEEP_DELAY);
  }

  /** Returns whether fast bodies are stopped at what they would pass through. */
  public final boolean continuous() {
    return value(Constant.CONTINUOUS) != 0;
  }

  /** Returns the approach speed above which a hit is reported, m/s. */
  public final float hitSpeed() {
    return value(Constant.HIT_SPEED);
  }

  /** Returns whether positions advance by the old velocities, not the new ones. */
  public final boolean explicitEuler() {
    return value(Constant.INTEGRATOR) != 0;
  }

  /** Returns how the friction of two shapes without a rule of their own is mixed. */
  public final MixingRule frictionMixing() {
    return RULES[(int) value(Constant.FRICTION_MIXING)];
  }

  /** Returns how the restitution of two shapes without a rule of their own is mixed. */
  public final MixingRule restitutionMixing() {
    return RULES[(int) value(Constant.RESTITUTION_MIXING)];
  }
}
