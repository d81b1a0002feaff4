package carom.physics.dynamics;

import java.util.Arrays;

/**
 * Which slot of {@link SolverBodies} each moving body has, from 1 on; all others have slot 0.
 *
 * <p>One thread takes the active bodies as they come. Where threads share a step, and bodies have
 * mixed since they were made, the world is cut into zones by the order of the tree, and the bodies
 * of a zone get slots that follow each other. What one thread solves then hardly shares lines of
 * the cache with what the others do. No bit of a result depends on slots.
 *
 * <p>One thread at a time. Costs nothing while the same bodies are active, but for zones: these are
 * looked at again every {@value #LASTING} steps, some 5 ns per body.
 */
final class SolverSlots {
  /** So many steps slots stay the same while the same bodies are active. */
  private static final int LASTING = 32;

  /** Zones have a power of two of slots: there are half as many as this, up to one more. */
  private static final int ZONES = 16;

  static final int MOST_ZONES = ZONES + 1;

  /** Bodies are mixed when one in so many is in another zone than the one before it. */
  private static final int MIXED_SHARE = 4;

  private final ActiveBodies active;
  private final PairFinder pairs;

  /** Per body: its slot. */
  int[] slotOf = new int[0];

  /** See {@link #zoneShift()}; so large without zones that all are in the first one. */
  private int zoneShift;

  /** Scratch: the next slot of each zone. */
  private final int[] zones = new int[MOST_ZONES];

  /** Per slot: its body. */
  private int[] body = new int[1];

  private int count = 1;

  /**
   * Which active bodies slots are of, whether zones were asked for, and for how many more steps.
   */
  private int version = -1;

  private boolean byZones;
  private int left;

  /** Scratch: bodies in the order of the tree, with one entry per part. */
  private int[] listed = new int[0];

  /** Gives these bodies slots; zones are those of the tree in which pairs are searched. */
  SolverSlots(ActiveBodies active, PairFinder pairs) {
    this.active = active;
    this.pairs = pairs;
  }

  /** By so many bits the slot of a body is shifted right to get its zone. */
  int zoneShift() {
    return zoneShift;
  }

  /** Slots in use, the static one included. */
  int count() {
    return count;
  }

  /**
   * Gives every active body a slot and the others none.
   *
   * @param shared whether threads share the step, so that zones are worth it
   */
  void assign(boolean shared) {
    if (slotOf.length < active.index.length) { // bodies may come that don't move
      slotOf = Arrays.copyOf(slotOf, active.index.length);
    }
    left--;
    if (version == active.version() && byZones == shared && (left >= 0 || !shared)) {
      return;
    }
    version = active.version();
    byZones = shared;
    left = LASTING;
    for (int i = 1; i < count; i++) {
      slotOf[body[i]] = 0;
    }
    if (body.length <= active.count) {
      body = new int[active.list.length + 1];
    }
    count = active.count + 1;
    boolean zoned = shared && areMixed();
    if (!zoned) {
      zoneShift = Integer.SIZE - 1;
    }
    for (int i = 0; i < active.count; i++) {
      int one = active.list[i];
      int next = zoned ? zones[slotOf[one] - 1]++ : i + 1;
      body[next] = one;
      slotOf[one] = next;
    }
  }

  /** Finds zones; answers whether bodies are in others than those next to them in the list. */
  private boolean areMixed() {
    zoneShift = Integer.SIZE - Integer.numberOfLeadingZeros(active.count / ZONES);
    findZones();
    int changes = 0;
    for (int i = 1; i < active.count; i++) {
      changes += slotOf[active.list[i]] != slotOf[active.list[i - 1]] ? 1 : 0;
    }
    return changes > active.count / MIXED_SHARE;
  }

  /** Gives each active body the number of its zone, from 1 on, and each zone its first slot. */
  private void findZones() {
    if (listed.length < pairs.movingParts()) {
      listed = new int[2 * pairs.movingParts()];
    }
    int n = pairs.listBodies(listed);
    int seen = 0;
    for (int i = 0; i < n; i++) {
      int one = listed[i];
      if (slotOf[one] == 0 && active.contains(one)) {
        slotOf[one] = 1 + (++seen >> zoneShift);
      }
    }
    for (int i = 0; i < active.count; i++) { // whatever has no parts
      if (slotOf[active.list[i]] == 0) {
        slotOf[active.list[i]] = 1 + (++seen >> zoneShift);
      }
    }
    for (int zone = 0; zone <= seen >> zoneShift; zone++) {
      zones[zone] = Math.max(zone << zoneShift, 1);
    }
  }
}
