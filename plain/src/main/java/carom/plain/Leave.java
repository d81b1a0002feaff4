package carom.plain;

/** Leaves; the server keeps no place. */
public final class Leave {
  /** Creates one to be filled in. */
  public Leave() {}
}
