package carom.plain;

/** An entry of a {@link BestList}. */
public final class BestEntry {
  /** Name under which the account played last. */
  public String name;

  /** Value for people. */
  public String value;

  /** Creates one to be filled in. */
  public BestEntry() {}
}
