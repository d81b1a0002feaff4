package carom.physics.dynamics.body;

import carom.physics.geometry.Shape;
import carom.physics.math.StateHash;
import carom.physics.settings.MixingRule;

/**
 * A shape of a body with all that belongs to it, as the engine takes it over; see {@code
 * carom.physics.ShapeDef}, {@code Material} and {@code Filter} for what each number does.
 *
 * @param shape in the body frame
 * @param density kg/m^2
 * @param friction Coulomb coefficient
 * @param restitution speed after by speed before
 * @param rollingResistance torque by radius and load
 * @param tangentSpeed of the surface, m/s
 * @param category bits
 * @param mask bits
 * @param group 0 for none
 * @param sensor whether it only notices
 * @param frictionMixing null for the world's
 * @param restitutionMixing null for the world's
 */
public record ShapeSpec(
    Shape shape,
    float density,
    float friction,
    float restitution,
    float rollingResistance,
    float tangentSpeed,
    int category,
    int mask,
    int group,
    boolean sensor,
    MixingRule frictionMixing,
    MixingRule restitutionMixing) {

  static final int DEFAULT_CATEGORY = 1;
  static final int DEFAULT_MASK = -1;

  /** Returns whether the filter lets everything through and the shape is solid. */
  boolean plain() {
    return category == DEFAULT_CATEGORY && mask == DEFAULT_MASK && group == 0 && !sensor;
  }

  /** Adds to a hash what differs from the defaults; what every shape has is added elsewhere. */
  long mix(long hash, boolean dynamic) {
    long h = hash;
    if (!plain()) {
      h = StateHash.mix(h, ((long) category << 32) | (mask & 0xffffffffL));
      h = StateHash.mix(h, ((long) group << 1) | (sensor ? 1 : 0));
    }
    if (rollingResistance != 0 || tangentSpeed != 0) {
      h = StateHash.mix(h, rollingResistance, tangentSpeed);
    }
    if (frictionMixing != null || restitutionMixing != null) {
      h = StateHash.mix(h, MaterialMixing.code(frictionMixing, restitutionMixing));
    }
    if (!dynamic && density != 1) {
      h = StateHash.mix(h, density, 0);
    }
    return h;
  }
}
