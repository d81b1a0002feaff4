package carom.net.snapshot;

import carom.net.snapshot.frame.QuantizedPose;

/**
 * Holds what a client has received of one entity slot: up to {@link #SIZE} states, each exactly the
 * server's quantised state after its tick. Index 0 is the newest. An entity that rested has an
 * entry at the end of its rest too, so that between two neighbouring entries there is a movement
 * that really took that long.
 */
public final class EntityHistory {

  /** Number of states kept, at most. */
  public static final int SIZE = 64;

  private static final int FREE = -1;
  private static final int OUT_OF_SIGHT = -2;
  private static final int FIRST_ROOM = 4;
  private static final int TICK = 0;
  private static final int KIND = 1;
  private static final int OWNER = 2;
  private static final int X = 3;
  private static final int Y = 4;
  private static final int ANGLE = 5;
  private static final int STILL = 6;
  private static final int FIELDS = 7;
  private static final int TELEPORT_SHIFT = 24;

  // Most entities rest for good: room for a few states, doubled as needed.
  private int[] data = new int[FIRST_ROOM * FIELDS];
  private int mask = FIRST_ROOM - 1;
  private int newest;
  private int newestTick = -1;
  private int size;

  EntityHistory() {}

  /** Returns the number of states held, 1..{@link #SIZE}. */
  public int size() {
    return size;
  }

  /** Returns whether the newest known state is a living entity. */
  public boolean alive() {
    return size > 0 && alive(0);
  }

  /** Returns the index of the newest entry at or before a tick, or -1. */
  public int indexAt(int tick) {
    for (int i = 0; i < size; i++) {
      if (tick(i) <= tick) {
        return i;
      }
    }
    return -1;
  }

  /** Returns the same as {@link #indexAt(int)}, at once if a guess is right. */
  int indexAt(int tick, int guess) {
    boolean right =
        guess >= 0 && guess < size && tick(guess) <= tick && (guess == 0 || tick(guess - 1) > tick);
    return right ? guess : indexAt(tick);
  }

  /** Returns the tick of an entry. */
  public int tick(int index) {
    return data[at(index) + TICK];
  }

  /**
   * Returns whether the slot held an entity in sight then. If not, the entry's other values mean
   * nothing.
   */
  public boolean alive(int index) {
    return data[at(index) + KIND] >= 0;
  }

  /**
   * Returns whether the slot went out of the client's sight then. An entity may still be there, and
   * nothing has happened to it that a player should notice.
   */
  public boolean outOfSight(int index) {
    return data[at(index) + KIND] == OUT_OF_SIGHT;
  }

  /** Returns the generation: entries of different generations are different entities. */
  public int generation(int index) {
    return data[at(index) + KIND] & 0xff;
  }

  /** Returns the archetype index. */
  public int archetype(int index) {
    return data[at(index) + KIND] >>> 8 & 0xffff;
  }

  /**
   * Returns how often the entity was teleported, modulo 16. Between entries with different numbers
   * it did not move through the space between.
   */
  public int teleports(int index) {
    return data[at(index) + KIND] >>> TELEPORT_SHIFT;
  }

  /** Returns generation, archetype and teleports as {@link #kindOf} packs them. */
  int kind(int index) {
    return data[at(index) + KIND];
  }

  static int kindOf(int generation, int archetype, int teleports) {
    return teleports << TELEPORT_SHIFT | archetype << 8 | generation;
  }

  /** Returns whose the entity is, see {@code Ownership}. */
  public int ownership(int index) {
    return data[at(index) + OWNER];
  }

  /** Returns the x of the position in steps; {@code Quantizer.positionOf} gives metres. */
  public int x(int index) {
    return data[at(index) + X];
  }

  /** Returns the y of the position in steps. */
  public int y(int index) {
    return data[at(index) + Y];
  }

  /** Returns the angle in steps, 0..1,023; {@code Quantizer.angleOf} gives radians. */
  public int angle(int index) {
    return data[at(index) + ANGLE];
  }

  /** Returns whether the entity stood still: it stays there until a later state says otherwise. */
  public boolean still(int index) {
    return data[at(index) + STILL] != 0;
  }

  private int at(int index) {
    if (index < 0 || index >= size) {
      throw new IndexOutOfBoundsException("index=" + index + " is outside 0.." + (size - 1));
    }
    return ((newest - index) & mask) * FIELDS;
  }

  void pose(int index, QuantizedPose out) {
    int at = at(index);
    out.set(data[at + X], data[at + Y], data[at + ANGLE], data[at + STILL] != 0);
  }

  /**
   * Adds an entry that repeats an older one at a later tick, unless that tick has one: the state
   * held until then.
   */
  void hold(int index, int tick, QuantizedPose scratch) {
    if (tick(index) != tick) {
      pose(index, scratch);
      add(tick, kind(index), ownership(index), scratch);
    }
  }

  /** Adds a state of a living entity. */
  void add(int tick, int kind, int owner, QuantizedPose pose) {
    int at = open(tick);
    if (at >= 0) {
      data[at + KIND] = kind;
      data[at + OWNER] = owner;
      data[at + X] = pose.x;
      data[at + Y] = pose.y;
      data[at + ANGLE] = pose.angle;
      data[at + STILL] = pose.still ? 1 : 0;
    }
  }

  /** Adds that the slot was free. */
  void addFree(int tick) {
    int at = open(tick);
    if (at >= 0) {
      data[at + KIND] = FREE;
    }
  }

  /** Adds that the slot was out of sight. */
  void addOutOfSight(int tick) {
    int at = open(tick);
    if (at >= 0) {
      data[at + KIND] = OUT_OF_SIGHT;
    }
  }

  /**
   * Makes room for an entry in the order of ticks and returns where it begins; -1 when the tick is
   * there already or older than a full history.
   */
  private int open(int tick) {
    int newer = 0;
    if (tick > newestTick) { // mostly: looks at no entry, which may be far from any cache
      newestTick = tick;
    } else {
      while (newer < size && tick(newer) > tick) {
        newer++;
      }
      if (newer == SIZE || (newer < size && tick(newer) == tick)) {
        return -1;
      }
    }
    if (size > mask && size < SIZE) {
      grow();
    }
    newest = (newest + 1) & mask;
    size = Math.min(SIZE, size + 1);
    for (int i = 0; i < newer; i++) {
      System.arraycopy(data, at(i + 1), data, at(i), FIELDS);
    }
    int at = at(newer);
    data[at + TICK] = tick;
    return at;
  }

  private void grow() {
    int[] grown = new int[2 * data.length];
    for (int i = 0; i < size; i++) {
      System.arraycopy(data, at(i), grown, (size - 1 - i) * FIELDS, FIELDS);
    }
    data = grown;
    mask = 2 * mask + 1;
    newest = size - 1;
  }
}
