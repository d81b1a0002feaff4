package carom.plain;

/** Lets a client in; a {@link Match} follows. */
public final class Welcome {
  /** Version of the server's classes. */
  public int version;

  /** Takes the same place again after a lost connection, see {@link Join}. */
  public long secret;

  /** Ticks a second. */
  public int tickRate;

  /** Snapshots a second until {@link Rate} asks for others. */
  public int rate;

  /** Creates one to be filled in. */
  public Welcome() {}
}
