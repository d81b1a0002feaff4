package carom.server.session;

import carom.net.admission.AddressGroup;
import carom.net.protocol.PlayerName;
import carom.net.protocol.ProtocolLimits;
import carom.server.account.PlayerSkill;
import carom.server.account.Stay;
import carom.sim.Skill;
import carom.text.Texts;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.LongSupplier;

/**
 * The seats of a room: player ids, names and session secrets. The lobby hands seats out and the
 * room frees them; this is the one object that both share. Every method may be called from any
 * thread and holds a lock for a few comparisons.
 *
 * <p>A seat is taken while a link on its way claims it or a session in the room occupies it; a
 * returning player claims a seat that is still occupied.
 *
 * <p>A player who goes to another room of a server that keeps checkpoints leaves a
 * <em>reserved</em> seat behind. It is free when the other room has the arrival on the disk ({@link
 * Seat#settle}), so that after a crash the player has a seat in one of the two rooms. A player has
 * seats of several rooms only then; the one to which the player went last counts ({@link
 * #switchesOf}).
 */
public final class Seats {
  private static final long RESUME_INTERVAL_MS = 1_500;
  private static final long NS_PER_MS = 1_000_000;

  /** Beginning of the token by which a bot takes a seat. */
  public static final String BOT = "bot:";

  /** The group that bots count for. */
  private static final AddressGroup BOTS = new AddressGroup("bots", "bots");

  /** Origin of players that were restored and haven't come back, or sit down in tests. */
  private static final AddressGroup UNKNOWN = new AddressGroup("", "");

  private final Seat[] taken = new Seat[ProtocolLimits.MAX_PLAYERS];
  private volatile int count;
  private final Set<String> foldedNames = new HashSet<>();
  private final Set<String> skeletons = new HashSet<>();
  private int takenCount;
  private int reservedCount;
  private final LongSupplier secrets;
  private final int incarnation;
  private int version;
  private long seatings;

  /**
   * Creates free seats.
   *
   * @param count number of seats, 1..1,024
   * @param secrets unpredictable numbers, for session secrets
   */
  public Seats(int count, LongSupplier secrets) {
    this.count = count;
    this.secrets = secrets;
    incarnation = (int) secrets.getAsLong();
  }

  /**
   * Returns an unpredictable number that stands for this run of the room. A room that was resumed
   * from a checkpoint has another.
   */
  public int incarnation() {
    return incarnation;
  }

  /** Returns a number that changes whenever a player may have come or gone. */
  public synchronized int version() {
    return version;
  }

  /**
   * Takes a free seat for a bot, which {@linkplain #order comes} by a token.
   *
   * @return the seat, or null when all are taken
   */
  public synchronized Seat takeForBot(String wantedName) {
    Seat seat = take(wantedName, "", BOTS);
    if (seat != null) {
      seat.born = true;
      seat.bots = true;
    }
    return seat;
  }

  /**
   * Lets a bot come to a seat: to one taken for it, or to one whose player has lost the connection
   * or left.
   *
   * @return the token, which lets one link in, once; for the bot alone
   */
  public synchronized String order(Seat seat) {
    seat.botToken = BOT + Long.toHexString(freshSecret());
    return seat.botToken;
  }

  /** Returns whether a bot may come to a seat, and hasn't yet. */
  public synchronized boolean isOrdered(Seat seat) {
    return seat.botToken != null;
  }

  /** Ends an order. A seat that was taken for a bot becomes free. */
  public synchronized void withdraw(Seat seat) {
    if (seat.botToken != null) {
      seat.botToken = null;
      if (!seat.occupied) {
        seat.claims--;
        freeIfUnused(seat);
      }
    }
  }

  /** Claims the seat to which a token lets a bot, or returns null; the token is spent then. */
  public synchronized Seat claimForBot(String token) {
    for (Seat seat : taken) {
      if (seat != null && token.equals(seat.botToken)) {
        seat.botToken = null;
        seat.claims += seat.occupied ? 1 : 0; // one taken for a bot has its claim already
        return seat;
      }
    }
    return null;
  }

  /** Gives a seat to the bots for good: its player doesn't come back, and has no account there. */
  public synchronized void forsake(Seat seat) {
    seat.bots = true;
    seat.account = "";
    seat.party = "";
    seat.stay = null;
    seat.group = BOTS;
    version++;
  }

  /**
   * Gives a player of an earlier run of the room the seat back. It counts as occupied.
   *
   * @param account as {@link Seat#account}
   * @param courseTick as {@link Seat#courseTick}
   * @param switches as {@link Seat#switches}
   * @return the seat, or null if there is no such seat, or it is taken
   */
  public synchronized Seat restore(
      int id,
      String wantedName,
      String name,
      String account,
      long secret,
      int courseTick,
      int switches) {
    if (id >= count || taken[id] != null || secret == 0) {
      return null;
    }
    Seat seat = new Seat(id, wantedName, name, account, secret, switches);
    seat.seatedAt(seatings++, UNKNOWN);
    seat.courseTick = courseTick;
    seat.occupied = true;
    foldedNames.add(PlayerName.folded(name));
    skeletons.add(PlayerName.skeleton(name));
    taken[id] = seat;
    takenCount++;
    return seat;
  }

  /**
   * Takes the free seat with the lowest id and claims it under the wanted name. A name that is
   * taken, or that looks like a taken one, gets a number behind it: {@code Ann (2)}.
   *
   * @param wantedName a legal name
   * @return the seat, or null when all are taken
   */
  public synchronized Seat take(String wantedName) {
    return take(wantedName, "", UNKNOWN);
  }

  /**
   * Takes a seat as {@link #take(String)} does.
   *
   * @param account the player's account by its join token, or empty
   * @param origin where the player comes from
   */
  public synchronized Seat take(String wantedName, String account, AddressGroup origin) {
    return take(wantedName, account, origin, freshSecret(), 0);
  }

  /**
   * Takes a seat as {@link #take(String)} does, for a player who comes from another room. The
   * player keeps the secret and stays muted.
   *
   * @param from the seat in the other room
   * @param room the seats of the other room
   */
  public Seat takeFor(Seat from, Seats room) {
    Seat back = find(from.secret); // the player was here a moment ago
    if (back != null) {
      free(back);
    }
    synchronized (this) {
      Seat seat = take(from.wantedName, from.account, from.group, from.secret, from.switches + 1);
      if (seat != null) {
        seat.muted = from.muted;
        seat.party = from.party;
        seat.skill = from.skill;
        seat.behind = () -> room.free(from);
      }
      return seat;
    }
  }

  private synchronized Seat take(
      String wantedName, String account, AddressGroup origin, long secret, int switches) {
    for (int id = 0; id < count && takenCount < count; id++) {
      if (taken[id] == null) {
        Seat seat = new Seat(id, wantedName, freeName(wantedName), account, secret, switches);
        seat.seatedAt(seatings++, origin);
        seat.claims = 1;
        foldedNames.add(PlayerName.folded(seat.name));
        skeletons.add(PlayerName.skeleton(seat.name));
        taken[id] = seat;
        takenCount++;
        return seat;
      }
    }
    return null;
  }

  /**
   * Returns {@link Seat#switches} of the seat that belongs to a secret, or -1 if none does. Of the
   * seats of several rooms, the one with the largest number is the player's.
   */
  public synchronized int switchesOf(long secret) {
    Seat seat = find(secret);
    return seat == null ? -1 : seat.switches;
  }

  /** Returns the account of the player whose seat belongs to a secret, or an empty text. */
  public synchronized String accountOf(long secret) {
    Seat seat = find(secret);
    return seat == null ? "" : seat.account;
  }

  /** Returns how many seats an account has. */
  public synchronized int countOf(String account) {
    int count = 0;
    for (Seat seat : taken) {
      count += seat != null && seat.account.equals(account) ? 1 : 0;
    }
    return count;
  }

  /** Returns the accounts that have a seat, those with the lowest ids first. */
  public synchronized Set<String> accounts() {
    Set<String> accounts = new LinkedHashSet<>();
    for (Seat seat : taken) {
      if (seat != null && !seat.account.isEmpty()) {
        accounts.add(seat.account);
      }
    }
    return accounts;
  }

  /**
   * Returns the skill of those who have a seat and whose skill is known.
   *
   * @param skill that the game names
   */
  public synchronized RoomSkill skill(String game, Skill skill) {
    RoomSkill nobody = RoomSkill.ofNobody(skill);
    int players = 0;
    long sum = 0;
    for (Seat seat : taken) {
      PlayerSkill known = seat == null || seat.bots ? PlayerSkill.UNKNOWN : seat.skillNow();
      if (known.isKnown()) {
        players++;
        sum += known.in(game, nobody.field(), nobody.start());
      }
    }
    return players == 0 ? nobody : nobody.with(players, (int) (sum / players));
  }

  /** Returns how many members of a party have a seat. */
  public synchronized int membersOf(String party) {
    int count = 0;
    for (Seat seat : taken) {
      count += seat != null && seat.party.equals(party) ? 1 : 0;
    }
    return count;
  }

  /** Returns the parties of which a member has a seat, those with the lowest ids first. */
  public synchronized Set<String> parties() {
    Set<String> parties = new LinkedHashSet<>();
    for (Seat seat : taken) {
      if (seat != null && !seat.party.isEmpty()) {
        parties.add(seat.party);
      }
    }
    return parties;
  }

  private synchronized Seat find(long secret) {
    for (int id = 0; secret != 0 && id < taken.length; id++) {
      if (taken[id] != null && !taken[id].bots && taken[id].secret == secret) {
        return taken[id];
      }
    }
    return null;
  }

  /**
   * Claims the seat that belongs to a secret, for a link that wants to resume it.
   *
   * @param origin where the link comes from
   * @param nowNs monotonic time; a seat is claimed at most once in {@value #RESUME_INTERVAL_MS} ms,
   *     so that a client that comes and goes in a loop is slowed down
   * @return null when no seat has this secret, or it was claimed a moment ago
   */
  public synchronized Seat claim(long secret, AddressGroup origin, long nowNs) {
    Seat seat = find(secret);
    boolean tooSoon =
        seat != null && seat.resumed && nowNs - seat.resumedNs < RESUME_INTERVAL_MS * NS_PER_MS;
    if (seat == null || tooSoon) {
      return null;
    }
    seat.resumed = true;
    seat.resumedNs = nowNs;
    seat.seatedAt(seat.order, origin);
    seat.claims++;
    return seat;
  }

  /** Ends one claim: the link will never arrive in the room. An empty seat becomes free. */
  public synchronized void unclaim(Seat seat) {
    seat.claims--;
    freeIfUnused(seat);
  }

  /** Turns one claim into possession: the link has arrived in the room. */
  public synchronized void occupy(Seat seat) {
    seat.claims--;
    seat.occupied = true;
    unreserve(seat);
    version++;
  }

  /** Notes that the player is gone. The seat becomes free unless a link claims it. */
  public void vacate(Seat seat) {
    synchronized (this) {
      seat.occupied = false;
      freeIfUnused(seat);
    }
    seat.settle();
  }

  /**
   * Reserves the seat of a player who goes to another room, unless a link claims it.
   *
   * @param untilNs monotonic time when the seat becomes free, if it doesn't before
   * @return whether it is reserved
   */
  public synchronized boolean reserve(Seat seat, long untilNs) {
    if (seat.claims > 0) {
      return false;
    }
    seat.occupied = false;
    seat.reserved = true;
    seat.reservedUntilNs = untilNs;
    reservedCount++;
    version++;
    return true;
  }

  /** Frees a seat that is reserved, unless a link claims it. */
  public void free(Seat seat) {
    synchronized (this) {
      if (!seat.reserved) {
        return;
      }
      unreserve(seat);
      freeIfUnused(seat);
    }
    seat.settle();
  }

  private void unreserve(Seat seat) {
    if (seat.reserved) {
      seat.reserved = false;
      reservedCount--;
      version++;
    }
  }

  /** Returns whether seats are reserved, which will be free soon. */
  public synchronized boolean hasReserved() {
    return reservedCount > 0;
  }

  /** Returns the seats that are reserved, in order of their ids. */
  public synchronized List<Seat> reserved() {
    List<Seat> all = new ArrayList<>(reservedCount);
    for (int id = 0; reservedCount > 0 && id < taken.length; id++) {
      if (taken[id] != null && taken[id].reserved) {
        all.add(taken[id]);
      }
    }
    return all;
  }

  /** Frees the reserved seats whose time is over. */
  public void expire(long nowNs) {
    if (hasReserved()) {
      for (Seat seat : reserved()) {
        if (nowNs - seat.reservedUntilNs >= 0) {
          free(seat);
        }
      }
    }
  }

  /** Returns whether a link is on its way to this seat. */
  public synchronized boolean isClaimed(Seat seat) {
    return seat.claims > 0;
  }

  /**
   * Returns the seat of a player who gives way to a newcomer because the player's network holds
   * more than its share, or null.
   *
   * @param account the newcomer's account, or empty
   * @param origin where the newcomer comes from
   */
  public synchronized Seat givesWay(SeatShares shares, String account, AddressGroup origin) {
    return shares.givesWay(taken, SeatShares.groupOf(account, origin));
  }

  private void freeIfUnused(Seat seat) {
    if (seat.claims == 0 && !seat.occupied && !seat.reserved && taken[seat.id] == seat) {
      taken[seat.id] = null;
      takenCount--;
      version++;
      foldedNames.remove(PlayerName.folded(seat.name));
      skeletons.remove(PlayerName.skeleton(seat.name));
    }
  }

  /**
   * Sets the number of seats, 1..1,024. If more are taken, their players stay until they leave by
   * themselves, and nobody else gets a seat until then.
   */
  public void resize(int newCount) {
    count = newCount;
  }

  /** Returns the number of seats, free ones included. */
  public int count() {
    return count;
  }

  /** Returns the number of seats that are taken. */
  public synchronized int takenCount() {
    return takenCount;
  }

  /** Returns the names of those who have the taken seats. */
  public synchronized List<String> names() {
    List<String> names = new ArrayList<>();
    for (Seat seat : taken) {
      if (seat != null) {
        names.add(seat.name);
      }
    }
    return names;
  }

  private long freshSecret() {
    long secret;
    do {
      secret = secrets.getAsLong();
    } while (secret == 0); // 0 means "no secret" on the wire
    return secret;
  }

  private String freeName(String wanted) {
    String name = wanted;
    for (int number = 2; isTaken(name); number++) {
      String suffix = " (" + number + ")";
      name = shortened(wanted, ProtocolLimits.MAX_NAME_BYTES - suffix.length()) + suffix;
    }
    return name;
  }

  private boolean isTaken(String name) {
    return foldedNames.contains(PlayerName.folded(name))
        || skeletons.contains(PlayerName.skeleton(name));
  }

  /**
   * Returns the longest beginning of a name that fits in some UTF-8 bytes and doesn't end in a
   * space.
   */
  private static String shortened(String name, int maxBytes) {
    return Texts.cut(name, maxBytes).stripTrailing();
  }

  /** One place in a room. */
  public static final class Seat {
    /** Stands for a player that has heard of the room's present course alone. */
    public static final int SAME_COURSE = Integer.MAX_VALUE;

    private final int id;
    private final String wantedName;
    private final String name;
    private volatile String account;
    private volatile String party = "";
    private volatile PlayerSkill skill = PlayerSkill.UNKNOWN;
    private final long secret;
    private final int switches;
    private int claims; // guarded by the seats' lock, as the next three
    private boolean occupied;
    private boolean reserved;
    private long reservedUntilNs;
    private long order;
    private AddressGroup group;
    private boolean resumed;
    private long resumedNs;
    private String botToken; // guarded, too; null for none
    private boolean born;
    private volatile boolean bots;
    private volatile int courseTick = SAME_COURSE;
    private boolean muted; // only the thread of the player's room uses it
    private volatile Stay stay;

    /** Frees the seat that the player left behind in another room; null if there is none. */
    private volatile Runnable behind;

    Seat(int id, String wantedName, String name, String account, long secret, int switches) {
      this.id = id;
      this.wantedName = wantedName;
      this.name = name;
      this.account = account;
      this.secret = secret;
      this.switches = switches;
    }

    private void seatedAt(long newOrder, AddressGroup origin) {
      order = newOrder;
      group = SeatShares.groupOf(account, origin);
    }

    /** Returns a number that is larger the later the player came; under the seats' lock. */
    long order() {
      return order;
    }

    /** Returns the group that the player counts for; under the seats' lock. */
    AddressGroup group() {
      return group;
    }

    /** Returns the name of the player's party, or an empty text. */
    public String party() {
      return party;
    }

    /** Sets the player's party; empty for none. */
    public void party(String newParty) {
      party = newParty;
    }

    /** Returns what was known of the player's skill when the player took the seat. */
    public PlayerSkill skill() {
      return skill;
    }

    /** Sets what is known of the player's skill. */
    public void skill(PlayerSkill newSkill) {
      skill = newSkill;
    }

    private PlayerSkill skillNow() {
      Stay now = stay;
      return now == null ? skill : new PlayerSkill(skill.claim(), now.values());
    }

    /** Returns how often the player has gone to another room. */
    public int switches() {
      return switches;
    }

    /** Returns whether the player has left no seat behind in another room; any thread. */
    public boolean isSettled() {
      return behind == null;
    }

    /**
     * Frees the seat that the player left behind in another room, because this room has the arrival
     * on the disk or the player has gone. Any thread, without a lock of any seats.
     */
    public void settle() {
      Runnable frees = behind;
      if (frees != null) {
        behind = null;
        frees.run();
      }
    }

    /** Returns whether a player plays here and no other link claims the seat; under its lock. */
    boolean givesWay() {
      return occupied && claims == 0;
    }

    /** Returns whether a bot has the seat for good: no player may come back to it. */
    public boolean isBots() {
      return bots;
    }

    /** Returns the name that others read while a bot plays here. */
    String nameOfBot() {
      String mark = " (bot)";
      return born ? name : shortened(name, ProtocolLimits.MAX_NAME_BYTES - mark.length()) + mark;
    }

    /** Mutes the player, whose chat and emotes are then dropped, or ends that. */
    public void mute(boolean on) {
      muted = on;
    }

    /** Returns whether the player is muted, which lasts until the player leaves the server. */
    public boolean isMuted() {
      return muted;
    }

    /** Returns the player's id, 0..1,023. */
    public int id() {
      return id;
    }

    /**
     * Returns the last tick that the room's present course shares with the one that the player has
     * heard of, or {@link #SAME_COURSE}. A room that is resumed goes back a little, and what comes
     * after that tick is another course. Any thread.
     */
    public int courseTick() {
      return courseTick;
    }

    /** Notes that the room has gone back to a tick. */
    public void returnsTo(int tick) {
      courseTick = Math.min(courseTick, tick);
    }

    /** Notes that the player hears of the present course. */
    void follows() {
      courseTick = SAME_COURSE;
    }

    /** Returns the name that the player asked for. */
    public String wantedName() {
      return wantedName;
    }

    /** Returns the player's name, unique in the room. */
    public String name() {
      return name;
    }

    /** Returns the player's account by its join token, or an empty text. */
    public String account() {
      return account;
    }

    /** Sets the stay of the account, before its player is in the room. */
    public void stay(Stay newStay) {
      stay = newStay;
    }

    /** Returns the stay of the account, or null for a stranger, or if no store answers. */
    public Stay stay() {
      return stay;
    }

    /** Returns the secret by which a returning client proves its identity; never 0. */
    public long secret() {
      return secret;
    }
  }
}
