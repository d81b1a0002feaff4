package carom.server.account;

import carom.net.protocol.ProtocolLimits;
import carom.physics.archive.Archive;
import java.util.Map;

/**
 * A write of an account's values in a game after a tick. They are absolute, so that writing them
 * twice counts once.
 */
public final class AccountWrite {
  /** Least bytes that one takes in an archive. */
  public static final int LEAST_BYTES = 40;

  private static final int MAX_NAME = 1 << 12;

  /**
   * The tick after which it is so.
   *
   * @param room name of the room
   * @param match number of the match
   * @param tick tick of the match
   */
  public record Place(String room, int match, int tick) {}

  final String account;
  final long stamp;
  final String name;
  final String game;
  final Map<String, AccountValues.Kept> values;
  final Place place;
  final boolean ends;
  private volatile boolean done;

  AccountWrite(
      String account,
      long stamp,
      String name,
      String game,
      Map<String, AccountValues.Kept> values,
      Place place,
      boolean ends) {
    this.account = account;
    this.stamp = stamp;
    this.name = name;
    this.game = game;
    this.values = values;
    this.place = place;
    this.ends = ends;
  }

  /**
   * Creates a write of what a stay has in a game now.
   *
   * @param name the player's name, for best lists
   * @param changed whether the values are to be written; otherwise only the end of the stay is
   * @param ends whether the player has left for good
   */
  public static AccountWrite of(
      Stay stay, String name, String game, Place place, boolean changed, boolean ends) {
    return new AccountWrite(
        stay.account(),
        stay.stamp(),
        name,
        game,
        changed ? stay.values().of(game) : Map.of(),
        place,
        ends);
  }

  /** Returns whether the store has it, or has refused it for good; any thread. */
  public boolean isDone() {
    return done;
  }

  /** Returns the account. */
  public String account() {
    return account;
  }

  /** Returns the stamp of the stay. */
  public long stamp() {
    return stamp;
  }

  /** Returns the name under which the player plays, for best lists. */
  public String name() {
    return name;
  }

  /** Returns the name of the game. */
  public String game() {
    return game;
  }

  /** Returns the values by the names of the fields; none to write the stay alone. Unmodifiable. */
  public Map<String, AccountValues.Kept> values() {
    return values;
  }

  /** Returns the tick after which it is so. */
  public Place place() {
    return place;
  }

  /** Returns whether it is the last of its stay. */
  public boolean isLast() {
    return ends;
  }

  void done() {
    done = true;
  }

  /** Reads or writes a write. */
  public static AccountWrite pass(Archive a, AccountWrite w) {
    String account =
        a.text("account", w == null ? "" : w.account, ProtocolLimits.MAX_ACCOUNT_CHARACTERS);
    long stamp = a.bits("stamp", w == null ? 0 : w.stamp);
    String name = a.text("name", w == null ? "" : w.name, ProtocolLimits.MAX_NAME_BYTES);
    String game = a.text("game", w == null ? "" : w.game, MAX_NAME);
    String room = a.text("room", w == null ? "" : w.place.room, MAX_NAME);
    int match = a.integer("match", w == null ? 0 : w.place.match, 0, Integer.MAX_VALUE);
    int tick = a.integer("tick", w == null ? 0 : w.place.tick, 0, Integer.MAX_VALUE);
    boolean ends = a.flag("ends", w != null && w.ends);
    Map<String, AccountValues.Kept> values =
        AccountValues.passKept(a, w == null ? Map.of() : w.values);
    return a.reads()
        ? new AccountWrite(account, stamp, name, game, values, new Place(room, match, tick), ends)
        : w;
  }
}
