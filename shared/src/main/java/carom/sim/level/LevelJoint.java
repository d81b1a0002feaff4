package carom.sim.level;

/**
 * A joint that the level places. Its definition is in the frames of its bodies, so that server and
 * clients make the same joint, to the bit, without a byte on the wire. Immutable.
 */
public final class LevelJoint {
  /** The end of a joint that holds a body to the world. */
  public static final int GROUND = Integer.MIN_VALUE;

  private final String name;
  private final int a;
  private final int b;
  private final int[] definition;

  LevelJoint(String name, int a, int b, int[] definition) {
    this.name = name;
    this.a = a;
    this.b = b;
    this.definition = definition;
  }

  /** Returns the name for {@code Simulation.joint}; empty for none. */
  public String name() {
    return name;
  }

  /**
   * Returns body A: a number in {@link Level#bodies}, an inverted one ({@code ~number}) in {@link
   * Level#statics}, or {@link #GROUND}.
   */
  public int a() {
    return a;
  }

  /** Returns body B: as {@link #a}, but never the ground. */
  public int b() {
    return b;
  }

  /** Returns {@code JointDefRow.INTS} ints: the live array, which must not be changed. */
  public int[] definition() {
    return definition;
  }
}
