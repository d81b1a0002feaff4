package carom.plain;

/** Asks for a number of snapshots a second. */
public final class Rate {
  /** Snapshots a second, 5..60. */
  public int perSecond = 30;

  /** Creates one to be filled in. */
  public Rate() {}

  /** Creates one. */
  public Rate(int perSecond) {
    this.perSecond = perSecond;
  }
}
