package carom.sim.event;

/** What an {@link EventKind} sounds like. A client makes the sounds; a game only chooses. */
public enum Sound {
  /** Silence. */
  NONE,
  /** Something hard hits something hard. */
  KNOCK,
  /** Something rushes off. */
  WHOOSH,
  /** A discharge: a shot, a jolt. */
  ZAP,
  /** A light jump. */
  HOP,
  /** A small reward. */
  CHIME,
  /** A great one: a goal, a flag. */
  FANFARE,
  /** Something is lost. */
  DROP
}
