package carom.plain;

/** Goes on with the lists of a {@link Match} that is too long for one message. */
public final class More {
  /** Further kinds of bodies; their indices go on. */
  public Archetype[] archetypes;

  /** Further bodies that never move. */
  public Ground[] ground;

  /** Creates one to be filled in. */
  public More() {}
}
