package carom.net.snapshot;

/** Seeded numbers for tests: splitmix64. */
public final class Dice {

  private long state;

  public Dice(long seed) {
    state = seed;
  }

  public long next() {
    state += 0x9e3779b97f4a7c15L;
    long z = state;
    z = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
    z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
    return z ^ (z >>> 31);
  }

  public int below(int bound) {
    return (int) Long.remainderUnsigned(next(), bound);
  }

  int between(int min, int max) {
    return min + below(max - min + 1);
  }

  public boolean percent(double chance) {
    return (next() >>> 11) * 0x1.0p-53 * 100 < chance;
  }
}
