package carom.plain;

/**
 * Bodies that changed since the last one. Several parts of one tick may come as several of these.
 */
public final class Snapshot {
  /** Tick of the poses. */
  public int tick;

  /** Count of the own input that was used last; -1 before the first. */
  public int input;

  /** {@link Match#number} of its match: skip what isn't of the newest one. */
  public int match;

  /** Number of this part, from 0. */
  public int part;

  /** Parts of this tick. */
  public int parts;

  /** Bodies that changed. */
  public Body[] bodies;

  /** Ids of bodies that are gone or out of sight. */
  public int[] gone;

  /** Creates one to be filled in. */
  public Snapshot() {}
}
