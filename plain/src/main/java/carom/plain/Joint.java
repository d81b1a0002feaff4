package carom.plain;

/** A joint, for drawing. */
public final class Joint {
  /** Type, such as DISTANCE or REVOLUTE. */
  public String type;

  /** Id of a body, or -1 for the ground. */
  public int first;

  /** Id of a body, or -1 for the ground. */
  public int second;

  /** Anchor in the first body's frame, or in the world's for the ground, metres. */
  public float ax;

  /** Anchor in the first body's frame, or in the world's for the ground, metres. */
  public float ay;

  /** Anchor in the second body's frame, or in the world's for the ground, metres. */
  public float bx;

  /** Anchor in the second body's frame, or in the world's for the ground, metres. */
  public float by;

  /** Creates one to be filled in. */
  public Joint() {}
}
