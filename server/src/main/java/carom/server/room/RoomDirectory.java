package carom.server.room;

import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Broadcast;
import carom.net.transport.Link;
import carom.server.account.AccountService;
import carom.server.session.ChatCommands;
import carom.server.upload.Uploads;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;

/**
 * The rooms of a server, by name, and the list that clients are sent. Any thread. A list is built
 * at most four times a second and shared, because every client may ask.
 */
public final class RoomDirectory {
  /** Number of rooms that {@link #describe} names. */
  private static final int MAX_DESCRIBED = 8;

  private static final long LIST_AGE_NS = 250_000_000;

  private volatile List<Room> rooms = List.of();
  private volatile ChatCommands chatCommands = ChatCommands.NONE;
  private volatile FleetDoor fleet = FleetDoor.NONE;
  private volatile AccountService accounts;
  private volatile Uploads uploads;
  private volatile BotCrew bots;
  private final Map<Link.Door, List<Broadcast>> lists = new EnumMap<>(Link.Door.class);
  private long listedNs;

  /** Creates a directory without rooms. */
  public RoomDirectory() {}

  /**
   * Adds the rooms, once.
   *
   * @param all the live list; any thread may read it
   */
  public void open(List<Room> all) {
    rooms = all;
  }

  /** Sets what shows the rooms of other servers. */
  public void fleet(FleetDoor door) {
    fleet = door;
  }

  /** Returns what shows the rooms of other servers. */
  public FleetDoor fleet() {
    return fleet;
  }

  /** Sets what keeps accounts; before the first turn. */
  public void accounts(AccountService service) {
    accounts = service;
  }

  /** Returns what keeps accounts, or null if nothing does. */
  public AccountService accounts() {
    return accounts;
  }

  /** Sets what keeps levels of players; before the first turn. */
  public void uploads(Uploads levels) {
    uploads = levels;
  }

  /** Returns what keeps levels of players, or null if the server takes none. */
  public Uploads uploads() {
    return uploads;
  }

  /** Sets what plays bots; before the first turn. */
  public void bots(BotCrew crew) {
    bots = crew;
  }

  /** Returns what plays bots, or null if nothing does. */
  public BotCrew bots() {
    return bots;
  }

  /** Sets who takes commands that players write into the chat of any room. */
  public void chatCommands(ChatCommands commands) {
    chatCommands = commands;
  }

  ChatCommands chatCommands() {
    return chatCommands;
  }

  /** Returns a room that is open, or null if there is none of this name. */
  public Room find(String name) {
    for (Room room : rooms) {
      if (room.name().equals(name) && !room.hasFailed()) {
        return room;
      }
    }
    return null;
  }

  /**
   * Returns the open room that suits a newcomer best, the first among equals; null if no room has a
   * place.
   *
   * @param takes whether a room takes newcomers; only open rooms are asked about
   */
  public Room best(RoomSearch search, Predicate<Room> takes) {
    Room best = null;
    int most = -1;
    for (Room room : rooms) {
      int fit = room.hasFailed() ? -1 : search.fit(room.offer());
      if (fit > most && takes.test(room)) {
        most = fit;
        best = room;
      }
    }
    return best;
  }

  /** Returns the open room in which a party has the most members; null if it has none. */
  public Room ofParty(String party) {
    Room best = null;
    int most = 0;
    for (Room room : rooms) {
      int members = party.isEmpty() || room.hasFailed() ? 0 : room.seats().membersOf(party);
      if (members > most) {
        most = members;
        best = room;
      }
    }
    return best;
  }

  /**
   * Returns the messages that list all open rooms.
   *
   * @param door that of the client, which decides to which other servers of the fleet it can go
   */
  public synchronized List<Broadcast> list(Link.Door door, long nowNs) {
    if (nowNs - listedNs > LIST_AGE_NS) {
      lists.clear();
      listedNs = nowNs;
    }
    return lists.computeIfAbsent(door, this::build);
  }

  private List<Broadcast> build(Link.Door door) {
    List<ServerMessage.RoomEntry> entries = entries(door);
    List<Broadcast> messages = new ArrayList<>();
    int from = 0;
    do {
      int to = Math.min(entries.size(), from + ProtocolLimits.MAX_LISTED_ROOMS);
      messages.add(
          new Broadcast(
              new ServerMessage.RoomList(entries.size() - to, entries.subList(from, to))));
      from = to;
    } while (from < entries.size());
    return List.copyOf(messages);
  }

  /** Returns what lists say about all open rooms, those of this server first. */
  private List<ServerMessage.RoomEntry> entries(Link.Door door) {
    List<ServerMessage.RoomEntry> entries = new ArrayList<>();
    for (Room room : rooms) {
      if (!room.hasFailed()) {
        entries.add(room.entry());
      }
    }
    entries.addAll(fleet.roomsElsewhere(door));
    return entries;
  }

  /**
   * Returns names and places of the rooms in a sentence, for a player who can't enter one.
   *
   * @param door as for {@link #list}
   */
  public String describe(Link.Door door) {
    StringBuilder text = new StringBuilder("Rooms: ");
    int described = 0;
    for (ServerMessage.RoomEntry room : entries(door)) {
      if (described++ < MAX_DESCRIBED) {
        text.append(described == 1 ? "" : ", ").append(room.name()).append(' ');
        text.append(room.players()).append('/').append(room.places());
      }
    }
    int more = described - MAX_DESCRIBED;
    return text.append(more > 0 ? " and " + more + " more." : ".").toString();
  }
}
