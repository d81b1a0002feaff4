package carom.plain;

/** Chooses what isn't null. */
public final class Choose {
  /** Number of the team. */
  public Integer team;

  /** PLAYER or SPECTATOR. */
  public String role;

  /** Readiness of the player. */
  public Boolean ready;

  /** Name of the colour. */
  public String colour;

  /** Name of the room to go to. */
  public String room;

  /** Creates one to be filled in. */
  public Choose() {}
}
