package carom.physics.dynamics.contact;

import carom.physics.dynamics.body.BodyStore;

/**
 * The name of a pair of shape parts: the smaller body index, the larger one, then the parts'
 * numbers within their bodies, as one positive long.
 *
 * <pre>
 *   bit  61        41 40         20 19      10 9        0
 *       |   body A   |   body B    |  part A  |  part B  |
 * </pre>
 *
 * <p>Contacts are kept in the order of their keys. A key depends on the bodies alone, never on when
 * the broadphase found the pair, so neither does any result.
 */
public final class ContactKey {
  private static final int BODY_BITS = BodyStore.SLOT_BITS;
  private static final int PART_BITS = BodyStore.PART_BITS;
  private static final int BODY_MASK = BodyStore.MAX_BODIES - 1;
  private static final int PART_MASK = BodyStore.MAX_PARTS - 1;

  private ContactKey() {}

  /** Returns the key of two parts, given by the bodies' slots and their numbers within these. */
  public static long of(int bodyA, int partA, int bodyB, int partB) {
    return ((long) bodyA << (BODY_BITS + 2 * PART_BITS))
        | ((long) bodyB << (2 * PART_BITS))
        | ((long) partA << PART_BITS)
        | partB;
  }

  /** Returns the slot of the body with the smaller index. */
  public static int bodyA(long key) {
    return (int) (key >>> (BODY_BITS + 2 * PART_BITS));
  }

  /** Returns the slot of the body with the larger index. */
  public static int bodyB(long key) {
    return (int) (key >>> (2 * PART_BITS)) & BODY_MASK;
  }

  /** Returns the number of A's part within A. */
  public static int partA(long key) {
    return (int) (key >>> PART_BITS) & PART_MASK;
  }

  /** Returns the number of B's part within B. */
  public static int partB(long key) {
    return (int) key & PART_MASK;
  }
}
