package carom.physics.settings;

/**
 * A rule by which the coefficients of two touching shapes become that of their contact, for
 * friction or restitution.
 *
 * <p>A world has a rule for each ({@code WorldDef.withFrictionMixing}, {@code
 * withRestitutionMixing}). A material may have rules of its own, which go before the world's. If
 * the materials of both shapes have one, that which stands later in this list counts. So the order
 * of the shapes never matters.
 */
public enum MixingRule {
  /** The mean of both, {@code (a + b) / 2}. */
  AVERAGE {
    @Override
    public float mix(float a, float b) {
      return 0.5f * (a + b);
    }
  },

  /** The geometric mean, {@code sqrt(a b)}: one zero makes it zero. The default for friction. */
  GEOMETRIC_MEAN {
    @Override
    public float mix(float a, float b) {
      return (float) Math.sqrt(a * b);
    }
  },

  /** The smaller one: ice is slippery for every body on it. */
  MIN {
    @Override
    public float mix(float a, float b) {
      return Math.min(a, b);
    }
  },

  /** The product, {@code a b}. */
  MULTIPLY {
    @Override
    public float mix(float a, float b) {
      return a * b;
    }
  },

  /** The larger one: a bumper throws everything back. The default for restitution. */
  MAX {
    @Override
    public float mix(float a, float b) {
      return Math.max(a, b);
    }
  };

  /**
   * Returns the coefficient of a contact.
   *
   * @param a coefficient of one shape, not negative
   * @param b coefficient of the other shape, not negative
   * @return the same for (b, a), bit for bit
   */
  public abstract float mix(float a, float b);
}
