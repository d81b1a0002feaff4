package carom.server.checkpoint;

import carom.net.protocol.ProtocolLimits;
import carom.physics.archive.Archive;
import carom.server.account.PlayerSkill;
import carom.server.account.Stay;
import carom.server.session.Seats;

/**
 * A player's place in a saved room. Immutable.
 *
 * @param id the player's number
 * @param wantedName the name that the player asked for
 * @param name the name that it plays under
 * @param account the player's account by its join token, or empty
 * @param party the name of the player's party, or empty
 * @param skill that the player's join token claims, or {@link PlayerSkill#NO_CLAIM}
 * @param secret proves the player's identity; never 0
 * @param muted whether its chat is dropped
 * @param graceMs what was left of the grace period, ms; {@link #PLAYED} if the player was there
 * @param courseTick as {@link Seats.Seat#courseTick}
 * @param switches as {@link Seats.Seat#switches}
 * @param reserved whether the player has gone to another room, which may not know it after a crash
 * @param sinceTick first tick at whose end the player may sit there
 * @param stay the stay of the account, or null
 * @param events places, in the list of the room, of the events that the player may not have heard
 *     of; never changed
 */
@SuppressWarnings("ArrayRecordComponent") // Never compared.
record SavedSeat(
    int id,
    String wantedName,
    String name,
    String account,
    String party,
    int skill,
    long secret,
    boolean muted,
    int graceMs,
    int courseTick,
    int switches,
    boolean reserved,
    int sinceTick,
    Stay stay,
    int[] events) {
  /** Stands for the whole grace period. */
  public static final int PLAYED = -1;

  static final int MAX_GRACE_MS = 600_000;
  private static final int BYTES = 52;

  /** Returns whether it is the seat with this id of the player with this secret. */
  boolean is(Seats.Seat seat) {
    return id == seat.id() && secret == seat.secret();
  }

  /** Returns the least bytes that a seat takes. */
  static int bytes() {
    return BYTES;
  }

  /** Passes a seat; null when reading. */
  static SavedSeat pass(Archive a, SavedSeat s, int eventCount) {
    boolean reads = a.reads();
    int id = a.integer("seat", reads ? 0 : s.id, 0, ProtocolLimits.MAX_PLAYERS - 1);
    String wanted = a.text("wanted name", reads ? "" : s.wantedName, ProtocolLimits.MAX_NAME_BYTES);
    String name = a.text("name", reads ? "" : s.name, ProtocolLimits.MAX_NAME_BYTES);
    String account =
        a.text("account", reads ? "" : s.account, ProtocolLimits.MAX_ACCOUNT_CHARACTERS);
    String party = a.text("party", reads ? "" : s.party, ProtocolLimits.MAX_PARTY_NAME_BYTES);
    int skill =
        a.integer("skill", reads ? 0 : s.skill, PlayerSkill.NO_CLAIM, PlayerSkill.MAX_CLAIM);
    long secret = a.bits("secret", reads ? 0 : s.secret);
    boolean muted = a.flag("muted", !reads && s.muted);
    int grace = a.integer("grace ms", reads ? 0 : s.graceMs, PLAYED, MAX_GRACE_MS);
    int course = a.integer("course tick", reads ? 0 : s.courseTick, 0, Seats.Seat.SAME_COURSE);
    int switches = a.integer("moves", reads ? 0 : s.switches, 0, Integer.MAX_VALUE);
    boolean reserved = a.flag("reserved", !reads && s.reserved);
    int since = a.integer("since", reads ? 0 : s.sinceTick, 0, Integer.MAX_VALUE);
    Stay stay = Stay.pass(a, reads ? null : s.stay);
    int count = a.count("events of seat", reads ? 0 : s.events.length, eventCount, Integer.BYTES);
    int[] events = reads ? new int[count] : s.events;
    a.integers("event of seat", events, count, 0, Math.max(0, eventCount - 1));
    return reads
        ? new SavedSeat(
            id, wanted, name, account, party, skill, secret, muted, grace, course, switches,
            reserved, since, stay, events)
        : s;
  }
}
