package carom.plain;

/** Asks for the best of what accounts keep in the game; {@link Best} answers. */
public final class ListBest {
  /** Creates one. */
  public ListBest() {}
}
