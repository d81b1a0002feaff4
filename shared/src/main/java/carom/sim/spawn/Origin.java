package carom.sim.spawn;

/**
 * The origin of an entity that {@code Game.input} of a player spawned: the tick, and the number of
 * the spawn in that call. Server and client compute the same origin, so it names the entity before
 * the client knows its id. Until then it is the entity's id there: origins are above all ids.
 *
 * <pre>
 *  30 29                       6 5       0
 * ┌──┬──────────────────────────┬─────────┐
 * │1 │ tick, its lowest 24 bits │ number  │
 * └──┴──────────────────────────┴─────────┘
 * </pre>
 *
 * <p>Origins are compared as a sequence that wraps after 2^24 ticks, three days at 60 Hz.
 */
public final class Origin {
  /** Origin of an entity that no {@code Game.input} spawned. */
  public static final int NONE = 0;

  /** Smallest origin. */
  public static final int FIRST = 1 << 30;

  /** Largest origin. */
  public static final int LAST = Integer.MAX_VALUE;

  /** Most entities that one call of {@code Game.input} may spawn. */
  public static final int MOST_PER_CALL = 64;

  /** Most entities with an origin that a player has at a time: the newest ones. */
  public static final int MOST_PER_PLAYER = 32;

  private static final int NUMBER_BITS = 6;
  private static final int NUMBER_MASK = MOST_PER_CALL - 1;
  private static final int TICK_MASK = (1 << 24) - 1;

  private Origin() {}

  /**
   * Returns the origin of a spawn.
   *
   * @param tick the tick that was computed, not negative
   * @param number of the spawn in the player's call of that tick, 0..63
   */
  public static int of(int tick, int number) {
    return FIRST | (tick & TICK_MASK) << NUMBER_BITS | number;
  }

  /**
   * Returns the id of an entity that a client spawns and drops in the input of another player,
   * whose spawns it doesn't predict. Players who spawn in the same tick have entities of the same
   * origin.
   */
  public static int passing(int origin) {
    return FIRST - MOST_PER_CALL + (origin & NUMBER_MASK);
  }

  /** Returns whether an id is that of a provisional entity: an origin, or a passing one. */
  public static boolean isProvisional(int id) {
    return id >= FIRST - MOST_PER_CALL;
  }

  /** Returns by how many ticks one origin is later than another; negative if it is earlier. */
  public static int ticksBetween(int earlier, int later) {
    int a = earlier >> NUMBER_BITS & TICK_MASK;
    int b = later >> NUMBER_BITS & TICK_MASK;
    return (b - a) << 8 >> 8;
  }

  /** Returns whether one origin is earlier than another. */
  public static boolean isEarlier(int origin, int than) {
    return (origin - than) << 2 < 0;
  }
}
