package carom.server.room;

import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.server.account.AccountLog;
import carom.server.account.AccountService;
import carom.server.account.AccountWrite;
import carom.server.account.BestLists;
import carom.server.account.Stay;
import carom.server.config.ServerConfig;
import carom.server.match.RoomContext;
import carom.server.session.Seats;
import carom.server.session.Session;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Newcomer;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;

/**
 * The gains of the accounts of a room's players, on their way to the store. A write waits here
 * until the room's journals have its tick, so that a room that goes on after a crash is never
 * behind what is stored.
 *
 * <pre>
 *   tick ── note ──► pending ── journals have it ──► AccountService ──► store
 * </pre>
 *
 * <p>The room's thread.
 */
final class RoomAccounts implements AccountLog {
  /** Changes are noted so often in a second: a game may change a field each tick. */
  private static final int PER_SECOND = 4;

  /** Most last writes of players who have left that wait for the store. */
  private static final int MOST_DEPARTED = 4_096;

  private record Pending(long number, Stay stay, AccountWrite write) {}

  private final RoomContext room;
  private final RoomDirectory directory;
  private final RoomSessions sessions;
  private final RoomJournals journals;
  private final String name;
  private final ArrayDeque<Pending> pending = new ArrayDeque<>();
  private final List<AccountWrite> departed = new ArrayList<>();
  private long noted;

  /**
   * Creates an object that has noted nothing.
   *
   * @param name the room's name
   */
  RoomAccounts(
      RoomContext room,
      RoomDirectory directory,
      RoomSessions sessions,
      RoomJournals journals,
      String name) {
    this.room = room;
    this.directory = directory;
    this.sessions = sessions;
    this.journals = journals;
    this.name = name;
  }

  private AccountService service() {
    return directory.accounts();
  }

  /**
   * Returns what a player brings into another match. A player without a store behind the account
   * keeps what lasts from match to match of a game, too.
   *
   * @param before the player in the present match
   */
  Newcomer newcomer(Seats.Seat seat, HostPlayer before, SimulationHost next) {
    boolean same = next.schema().digest() == before.fieldValues().schema().digest();
    int[] words =
        seat.stay() != null
            ? seat.stay().values().words(next.game().name(), next.schema())
            : same ? before.fieldValues().lasting() : null;
    if (seat.stay() != null) {
      seat.stay().begins(words);
    }
    return new Newcomer(seat.name(), seat.account(), words);
  }

  /** Lets the player of a seat join the match. */
  HostPlayer join(Seats.Seat seat) {
    SimulationHost s = room.simulation();
    Stay stay = seat.stay();
    int[] words = null;
    if (stay != null && service() != null) {
      words = stay.values().words(s.game().name(), s.schema());
      stay.begins(words);
      service().goesOn(stay);
      add(stay, write(stay, seat, stay.hasMoved(), false)); // older stays end with it
    }
    return s.join(seat.id(), new Newcomer(seat.name(), seat.account(), words), 0, 0);
  }

  /** Goes on with the stays of the players of an earlier run of the room. */
  void resumed() {
    for (int i = 0; i < sessions.count(); i++) {
      Stay stay = sessions.get(i).seat().stay();
      if (stay != null && service() != null) {
        service().goesOn(stay);
        standsIn(sessions.get(i), false);
        note(sessions.get(i));
      }
    }
  }

  /** Returns the best lists of the game that the room plays; from any thread. */
  List<BestLists.Table> best() {
    SimulationHost s = room.match().simulation();
    return service() == null ? List.of() : BestLists.of(service(), s.game().name(), s.schema());
  }

  /** Returns the best lists of that game for the player of an account, or of none if empty. */
  ServerMessage.BestLists best(String account) {
    return new ServerMessage.BestLists(
        best().stream()
            .limit(ProtocolLimits.MAX_BEST_LISTS)
            .map(table -> table.toldTo(account))
            .toList());
  }

  /** Returns what to tell a player whose account isn't known, or an empty text. */
  String trouble(Session session) {
    boolean unknown =
        service() != null
            && !session.seat().account().isEmpty()
            && session.seat().stay() == null
            && room.simulation().schema().lastingWords().length > 0;
    return unknown
        ? "What your account has isn't known now: you begin anew, and nothing of this stay is kept."
        : "";
  }

  /** Takes over what a player has now, and notes it if that is new. */
  void note(Session session) {
    note(session, false);
  }

  /** Notes what a player has who has left the match, between two ticks. */
  void left(Session session) {
    note(session, true);
  }

  private void note(Session session, boolean ends) {
    Stay stay = session.seat().stay();
    if (stay == null || service() == null) {
      return;
    }
    SimulationHost s = room.simulation();
    boolean changed =
        !stay.rests() && stay.note(s.game().name(), s.schema(), session.player().fieldValues());
    if (changed || ends) {
      add(stay, write(stay, session.seat(), changed || stay.hasChanged(), ends));
    }
  }

  /**
   * Begins the time in which a bot plays for a player, whose account gains nothing by that, or ends
   * it: the player then has again what the account has.
   */
  void standsIn(Session session, boolean begins) {
    Stay stay = session.seat().stay();
    if (stay == null || service() == null) {
      return;
    }
    if (begins) {
      note(session);
      stay.rests(true);
    } else if (stay.rests()) {
      SimulationHost s = room.simulation();
      int[] words = stay.values().words(s.game().name(), s.schema());
      if (!Arrays.equals(words, session.player().fieldValues().lasting())) {
        s.keep(session.player(), words);
      }
      stay.rests(false);
    }
  }

  private AccountWrite write(Stay stay, Seats.Seat seat, boolean changed, boolean ends) {
    AccountWrite.Place place =
        new AccountWrite.Place(name, room.match().info().number(), room.simulation().tick());
    String game = room.simulation().game().name();
    return AccountWrite.of(stay, seat.wantedName(), game, place, changed, ends);
  }

  private void add(Stay stay, AccountWrite write) {
    Iterator<Pending> newest = pending.descendingIterator();
    for (int of = 0; newest.hasNext(); ) {
      if (newest.next().stay == stay && ++of == 2) { // the older one may soon be let go
        newest = pending.descendingIterator();
        while (newest.next().stay != stay) {}
        newest.remove();
        break;
      }
    }
    pending.add(new Pending(++noted, stay, write));
    if (write.isLast()) {
      departed.removeIf(AccountWrite::isDone);
      if (departed.size() < MOST_DEPARTED) {
        departed.add(write);
      }
    }
  }

  /** Notes what has changed, some times a second, and lets go what the journals have. */
  void tickEnds() {
    if (service() == null) {
      return;
    }
    boolean due =
        room.age() % Math.max(1, room.config().get(ServerConfig.TICK_RATE) / PER_SECOND) == 0;
    for (int i = 0; due && i < sessions.count(); i++) {
      note(sessions.get(i));
    }
    letGo();
  }

  /** Hands the service what the journals have; also while the room rests, and when it has ended. */
  void letGo() {
    while (!pending.isEmpty() && pending.peek().number <= journals.accountsKept(noted)) {
      service().offer(pending.poll().write);
    }
  }

  /**
   * Notes what all players have, because the match or the room ends.
   *
   * @param ends whether the players' stays end with it
   */
  void noteAll(boolean ends) {
    for (int i = 0; i < sessions.count(); i++) {
      note(sessions.get(i), ends);
    }
  }

  @Override
  public long noted() {
    return noted;
  }

  @Override
  public List<AccountWrite> departed() {
    departed.removeIf(AccountWrite::isDone);
    return List.copyOf(departed);
  }

  @Override
  public void resumed(List<AccountWrite> writes) {
    if (service() != null) {
      writes.forEach(write -> pending.add(new Pending(++noted, null, write)));
      departed.addAll(writes);
    }
  }
}
