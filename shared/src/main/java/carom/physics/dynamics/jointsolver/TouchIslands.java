package carom.physics.dynamics.jointsolver;

import java.util.Arrays;

/**
 * Islands of what touches and of what joints hold, and the energy that each has got in a step. A
 * body stands for all that joints hold with it. Islands live as long as a question.
 */
final class TouchIslands {
  private int[] leader = new int[0];
  private boolean[] isCounted = new boolean[0];
  private boolean[] isOpen = new boolean[0];
  private double[] had = new double[0];
  private double[] gained = new double[0];

  /** Makes room for so many slots of bodies. */
  void ensure(int slots) {
    if (leader.length < slots) {
      int capacity = Math.max(slots, 2 * leader.length);
      leader = new int[capacity];
      isCounted = new boolean[capacity];
      isOpen = new boolean[capacity];
      had = new double[capacity];
      gained = new double[capacity];
    }
  }

  /** Makes each body an island of its own. */
  void begin(int slots) {
    ensure(slots);
    for (int i = 0; i < slots; i++) {
      leader[i] = i;
    }
    Arrays.fill(isCounted, 0, slots, false);
    Arrays.fill(isOpen, 0, slots, false);
    Arrays.fill(had, 0, slots, 0);
    Arrays.fill(gained, 0, slots, 0);
  }

  /** Makes the islands of two bodies one. To be called before the others. */
  void join(int a, int b) {
    leader[leader(b)] = leader(a);
  }

  /** Says that something may give energy to the island of a body that isn't in any island. */
  void open(int slot) {
    isOpen[leader(slot)] = true;
  }

  /** Returns true when asked about a body for the first time. */
  boolean isFirst(int slot) {
    boolean first = !isCounted[slot];
    isCounted[slot] = true;
    return first;
  }

  /** Adds energy of a body to its island: what it had when the step began, and what it has got. */
  void add(int slot, double before, double more) {
    int island = leader(slot);
    had[island] += before;
    gained[island] += more;
  }

  /**
   * Returns the energy that all others of the island of a body may have given it, J; infinite for
   * any.
   *
   * @param own energy that it has got, with all that stands for it
   * @param grain part of its energy that an island may get from nothing
   */
  double given(int slot, double own, double grain) {
    int island = leader(slot);
    double lost = own - gained[island] + grain * had[island];
    return isOpen[island] ? Double.POSITIVE_INFINITY : Math.max(lost, 0);
  }

  private int leader(int slot) {
    int at = slot;
    while (leader[at] != at) {
      leader[at] = leader[leader[at]];
      at = leader[at];
    }
    return at;
  }
}
