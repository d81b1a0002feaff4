package carom.server.account;

import carom.net.protocol.ProtocolLimits;
import carom.physics.archive.Archive;
import carom.sim.field.FieldValues;
import carom.sim.field.Schema;
import java.util.Arrays;

/**
 * One stay of an account's player on servers, from the join until the player leaves for good. Its
 * stamp is larger than the stamps of all earlier stays. Once a newer stay has written, the store
 * takes nothing from an older one.
 *
 * <pre>
 *   stamp   ┌ 31 bits ──────┬ 16 bits ─────────────────┬ 16 bits ─────────────────┐
 *           │ joins so far  │ rooms the player went to │ resumes from checkpoints │
 *           └───────────────┴──────────────────────────┴──────────────────────────┘
 * </pre>
 *
 * <p>So a player who plays twice at once gains for the account where the join was later, and a room
 * that comes back after a crash, older than where its player has gone, changes nothing. {@link
 * #values} is for any thread, the rest for the thread of the player's room.
 */
public final class Stay {
  private static final long ROOM_BITS = 0xffffL;
  private static final long JOIN_BITS = 0xffff_ffffL;

  private final String account;
  private final long stamp;
  private volatile AccountValues values;

  /** The values that were noted last, or null if they aren't certain to be stored. */
  private int[] noted;

  private long seen = -1;
  private boolean changed;
  private boolean rests;

  /**
   * Creates a stay.
   *
   * @param values what the account has
   */
  public Stay(String account, long stamp, AccountValues values) {
    this.account = account;
    this.stamp = stamp;
    this.values = values;
  }

  /** Returns the account, which is never empty. */
  public String account() {
    return account;
  }

  /** Returns the stamp. */
  public long stamp() {
    return stamp;
  }

  /** Returns what the account has now. */
  public AccountValues values() {
    return values;
  }

  /** Returns the stamp of the join after one with a stamp; 0 is before all. */
  public static long nextJoin(long stamp) {
    return (stamp | JOIN_BITS) + 1;
  }

  /** Returns the stay as it goes on in another room. */
  public Stay moved() {
    return new Stay(account, (stamp | ROOM_BITS) + 1, values);
  }

  /** Returns the stay as it goes on in a room that comes back from a checkpoint. */
  public Stay resumed() {
    Stay stay = new Stay(account, stamp + 1, values);
    stay.rests = rests;
    return stay;
  }

  /** Sets whether a bot plays for the player, so that the account gains nothing. */
  public void rests(boolean value) {
    rests = value;
  }

  /** Returns whether a bot plays for the player, or did until the room came back. */
  public boolean rests() {
    return rests;
  }

  /** Notes what the player begins with, which is stored already. */
  public void begins(int[] words) {
    noted = words;
  }

  /**
   * Takes over what the player has now.
   *
   * @return whether that is new
   */
  public boolean note(String game, Schema schema, FieldValues fields) {
    if (noted != null && fields.stamp() == seen) {
      return false;
    }
    seen = fields.stamp();
    int[] words = fields.lasting();
    if (words.length == 0 || Arrays.equals(words, noted)) {
      return false;
    }
    noted = words;
    changed = true;
    values = values.with(game, schema, words);
    return true;
  }

  /** Returns whether anything that was noted has changed since the join. */
  public boolean hasChanged() {
    return changed || hasMoved();
  }

  /** Returns whether it has gone on from another room, or after a crash. */
  public boolean hasMoved() {
    return (stamp & JOIN_BITS) != 0;
  }

  /** Reads or writes a stay; null stays null. */
  public static Stay pass(Archive a, Stay stay) {
    if (!a.flag("stay", stay != null)) {
      return null;
    }
    String account =
        a.text("account", stay == null ? "" : stay.account, ProtocolLimits.MAX_ACCOUNT_CHARACTERS);
    long stamp = a.bits("stamp", stay == null ? 0 : stay.stamp);
    boolean rests = a.flag("rests", stay != null && stay.rests);
    AccountValues values = AccountValues.pass(a, stay == null ? null : stay.values);
    if (!a.reads()) {
      return stay;
    }
    Stay read = new Stay(account, stamp, values);
    read.rests = rests;
    return read;
  }

  @Override
  public String toString() {
    return "account=" + account + " stamp=" + Long.toHexString(stamp);
  }
}
