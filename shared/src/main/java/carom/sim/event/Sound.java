package carom.sim.event;

/** The sound of an {@link EventKind}. A client makes the sounds; a game only chooses one. */
public enum Sound {
  /** The absence of any sound. */
  NONE,
  /** Two hard bodies that hit each other. */
  KNOCK,
  /** A body that rushes off. */
  WHOOSH,
  /** A discharge: a shot, a jolt. */
  ZAP,
  /** A light jump. */
  HOP,
  /** A small reward, such as a coin. */
  CHIME,
  /** A great reward, such as a goal or a flag. */
  FANFARE,
  /** A loss, such as a fall. */
  DROP
}
