package carom.plain;

/** Asks for a place: the first message of a client. */
public final class Join {
  /** Version of these classes. */
  public int version = Plain.VERSION;

  /** Name of the player. */
  public String name = "";

  /** Name of the room; empty for any. */
  public String room = "";

  /** Name of the game that the player wants if the room is any; empty for any. */
  public String game = "";

  /** Name of the party whose members the player wants to be with, if the room is any. */
  public String party = "";

  /** Join token of the game's operator; empty for none. It counts once. */
  public String token = "";

  /** Password of the server; empty for none. */
  public String password = "";

  /** Secret of an earlier {@link Welcome}, to take the same place again; 0 for none. */
  public long secret;

  /** Digest of the game's own classes; empty for none. */
  public String digest = "";

  /** Creates one to be filled in. */
  public Join() {}

  /** Creates one for a player of this name, in any room. */
  public Join(String name) {
    this.name = name;
  }

  /** Creates one that takes the place of a lost connection again. */
  public Join(String name, long secret) {
    this.name = name;
    this.secret = secret;
  }
}
