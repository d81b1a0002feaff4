package carom.plain;

/** Says nothing, but that the client is there. Stock KryoNet does that by itself. */
public final class Alive {
  /** Creates one to be filled in. */
  public Alive() {}
}
