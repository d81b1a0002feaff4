package carom.physics.math;

/**
 * A simulation's random numbers: splitmix64, whose whole state is one {@code long} that is hashed,
 * saved and restored with the simulation.
 *
 * <p>Source: Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014.
 * Games draw from it on the server only, because a client's prediction cannot know what the server
 * drew.
 */
public final class SimRandom {
  private static final long GAMMA = 0x9e3779b97f4a7c15L;

  private long state;

  /** Starts the sequence of a seed. */
  public SimRandom(long seed) {
    state = seed;
  }

  /** Returns the whole state; {@link #state(long)} continues from it. */
  public long state() {
    return state;
  }

  /** Continues the sequence from a state taken earlier. */
  public void state(long state) {
    this.state = state;
  }

  /** Returns the next 64 bits. */
  public long nextLong() {
    state += GAMMA;
    return mix(state);
  }

  /**
   * Returns a number in 0..bound-1, each equally likely to within 2^-32.
   *
   * @throws IllegalArgumentException when the bound is not positive
   */
  public int nextInt(int bound) {
    if (bound <= 0) {
      throw new IllegalArgumentException("bound=" + bound + " must be > 0");
    }
    return (int) (((nextLong() >>> 32) * bound) >>> 32);
  }

  /** Returns a number in [0, 1) in steps of 2^-24. */
  public float nextFloat() {
    return (nextLong() >>> 40) * 0x1p-24f;
  }

  /**
   * Returns a number between {@code low} (inclusive) and {@code high}, which rounding may reach.
   */
  public float between(float low, float high) {
    return low + (high - low) * nextFloat();
  }

  /** Mixes a value into a hash. */
  public static long mix(long hash, long value) {
    return mix(hash * GAMMA ^ value);
  }

  /**
   * Spreads every bit of the argument over all bits of the result, as splitmix64 does at its end.
   */
  static long mix(long z) {
    z = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
    z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
    return z ^ (z >>> 31);
  }
}
