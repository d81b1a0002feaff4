package carom.plain;

/**
 * Lists the joints in sight, all of them, whenever that list changes; a long one in several parts.
 */
public final class Joints {
  /** Number of this part, from 0. */
  public int part;

  /** Parts of this list. */
  public int parts;

  /** Joints. */
  public Joint[] joints;

  /** Creates one to be filled in. */
  public Joints() {}
}
