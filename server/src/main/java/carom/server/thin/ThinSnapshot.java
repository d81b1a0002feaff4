package carom.server.thin;

import java.util.Arrays;

/**
 * Holds what changed for one thin client: bodies in sight and ids that are gone. Reused from
 * snapshot to snapshot; a door encodes it at once. The room's thread.
 *
 * <p>Poses are in steps, so that a door may send differences: 1/512 m, and 1/1,024 of a turn,
 * counterclockwise.
 */
public final class ThinSnapshot {
  /** Steps in a metre. */
  public static final int STEPS_PER_METRE = 512;

  /** Steps in a turn. */
  public static final int STEPS_PER_TURN = 1_024;

  /** Tick of the poses. */
  public int tick;

  /** Count of the client's input that was used last, or -1. */
  public int input;

  /** Number of bodies. */
  public int count;

  /** Number of ids that are gone. */
  public int goneCount;

  /** Ids of the bodies, ascending. */
  public int[] id = {};

  /** Places, in {@link #STEPS_PER_METRE}. */
  public int[] x = {};

  /** Places, in {@link #STEPS_PER_METRE}. */
  public int[] y = {};

  /** Angles, 0..{@link #STEPS_PER_TURN} - 1. */
  public int[] angle = {};

  /**
   * Index of the archetype where the client may not know the body, or its kind or owner is another
   * one; else -1. A body that is told with its archetype is a new one or has jumped: nothing leads
   * from where it was.
   */
  public int[] archetype = {};

  /** Player that owns the body, or -1; meaningful where {@link #archetype} is told. */
  public int[] owner = {};

  /** Ids that are gone, ascending. */
  public int[] gone = {};

  /** Creates an empty snapshot. */
  public ThinSnapshot() {}

  /** Empties it. */
  public void clear(int newTick, int newInput) {
    tick = newTick;
    input = newInput;
    count = 0;
    goneCount = 0;
  }

  /** Adds a body. */
  public void add(int newId, int newX, int newY, int newAngle, int newArchetype, int newOwner) {
    if (count == id.length) {
      int size = Math.max(64, 2 * count);
      id = Arrays.copyOf(id, size);
      x = Arrays.copyOf(x, size);
      y = Arrays.copyOf(y, size);
      angle = Arrays.copyOf(angle, size);
      archetype = Arrays.copyOf(archetype, size);
      owner = Arrays.copyOf(owner, size);
    }
    id[count] = newId;
    x[count] = newX;
    y[count] = newY;
    angle[count] = newAngle;
    archetype[count] = newArchetype;
    owner[count] = newOwner;
    count++;
  }

  /** Adds an id that is gone. */
  public void addGone(int newId) {
    if (goneCount == gone.length) {
      gone = Arrays.copyOf(gone, Math.max(16, 2 * goneCount));
    }
    gone[goneCount++] = newId;
  }

  /** Returns another one that tells the same. */
  public ThinSnapshot copy() {
    ThinSnapshot copy = new ThinSnapshot();
    copy.clear(tick, input);
    for (int i = 0; i < count; i++) {
      copy.add(id[i], x[i], y[i], angle[i], archetype[i], owner[i]);
    }
    for (int i = 0; i < goneCount; i++) {
      copy.addGone(gone[i]);
    }
    return copy;
  }

  /** Returns whether it tells nothing. */
  public boolean isEmpty() {
    return count == 0 && goneCount == 0;
  }
}
