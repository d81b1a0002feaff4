package carom.net.transport;

/**
 * Random number generator splitmix64 (Steele, Lea and Flood, 2014). A seed gives the same numbers
 * on every machine and in every version.
 */
final class SplitMix {

  private long state;

  SplitMix(long seed) {
    state = seed;
  }

  long next() {
    state += 0x9e3779b97f4a7c15L;
    long z = state;
    z = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
    z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
    return z ^ (z >>> 31);
  }

  /** Returns a uniformly distributed number in 0 (inclusive) .. 1 (exclusive). */
  double unit() {
    return (next() >>> 11) * 0x1.0p-53;
  }
}
