package carom.physics.dynamics.contact;

import carom.physics.dynamics.body.BodyStore;

/**
 * The name of a pair of shape parts: the smaller body index, the larger one, then the parts'
 * numbers within their bodies, as one positive long.
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

  public static long of(int bodyA, int partA, int bodyB, int partB) {
    return ((long) bodyA << (BODY_BITS + 2 * PART_BITS))
        | ((long) bodyB << (2 * PART_BITS))
        | ((long) partA << PART_BITS)
        | partB;
  }

  public static int bodyA(long key) {
    return (int) (key >>> (BODY_BITS + 2 * PART_BITS));
  }

  public static int bodyB(long key) {
    return (int) (key >>> (2 * PART_BITS)) & BODY_MASK;
  }

  public static int partA(long key) {
    return (int) (key >>> PART_BITS) & PART_MASK;
  }

  public static int partB(long key) {
    return (int) key & PART_MASK;
  }
}
