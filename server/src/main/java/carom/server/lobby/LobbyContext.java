package carom.server.lobby;

import carom.net.admission.AddressGroup;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.server.access.EntryRule;
import carom.server.access.GamePassword;
import carom.server.config.ServerConfig;
import carom.server.room.FleetDoor;
import carom.server.room.Room;
import carom.server.room.RoomDirectory;
import carom.server.session.PartingLinks;
import carom.server.threads.TickLoad;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The context that the visitors of a lobby share: the rooms they choose from, the rules at the
 * door, the time of the turn, and who else is there.
 *
 * <p>On the lobby's thread, except {@link #admit} and {@link #demand}.
 */
final class LobbyContext {
  private static final Logger LOG = LoggerFactory.getLogger(LobbyContext.class);
  private static final long NS_PER_MS = 1_000_000;
  private static final long PARTING_MS = 1_000;

  /** Links that may be told goodbye at once; those of players who leave are a room's. */
  static final int MAX_PARTINGS = 64;

  /** Seats that one network may hold while it loads, even when seats are short. */
  private static final int LOADING_OF_NETWORK = 8;

  private final Supplier<ServerConfig> config;
  private final List<Room> rooms;
  private final RoomChooser chooser;
  private final RoomDirectory directory;
  private final List<Visitor> visitors = new ArrayList<>();
  private final PartingLinks partings = new PartingLinks(MAX_PARTINGS);
  private final AdmissionRate rate;
  private final Spectators spectators;
  private volatile EntryRule entryRule = EntryRule.OPEN;
  private volatile GamePassword password;
  private final Map<Long, Visitor> standbys = new HashMap<>();
  private long nowNs;

  LobbyContext(Supplier<ServerConfig> config, List<Room> rooms, RoomDirectory directory) {
    this.rooms = rooms;
    this.config = config;
    this.directory = directory;
    chooser =
        new RoomChooser(
            rooms,
            () -> (int) Math.round(100 * config.get().get(ServerConfig.MAX_LOAD)),
            TickLoad.ticksUntilKnown(config.get().get(ServerConfig.TICK_RATE)));
    spectators = new Spectators(rooms);
    rate = new AdmissionRate(places());
  }

  /** Returns the present settings of the server. */
  ServerConfig config() {
    return config.get();
  }

  /** Returns what chooses a room for a visitor. */
  RoomChooser chooser() {
    return chooser;
  }

  /** Returns the server's rooms by name. */
  RoomDirectory directory() {
    return directory;
  }

  /** Returns the number of seats of all rooms. */
  int places() {
    return rooms.stream().mapToInt(room -> room.seats().count()).sum();
  }

  /** Returns the visitors in order of arrival. */
  List<Visitor> visitors() {
    return visitors;
  }

  /** Tells the rest of the fleet who looks here for players about as good. */
  void tellLookers() {
    FleetDoor fleet = directory.fleet();
    if (visitors.isEmpty()) {
      fleet.look(List.of()); // as in most turns, which allocate nothing
    } else {
      fleet.look(visitors.stream().map(Visitor::looker).filter(Objects::nonNull).toList());
    }
  }

  /** Returns the links that are told goodbye. */
  PartingLinks partings() {
    return partings;
  }

  /** Returns how often each host may join. */
  AdmissionRate rate() {
    return rate;
  }

  /** Returns the links that watch. */
  Spectators spectators() {
    return spectators;
  }

  /** Returns who may come in now. */
  EntryRule entryRule() {
    return entryRule;
  }

  /** Returns the monotonic time of the present turn, ns. */
  long nowNs() {
    return nowNs;
  }

  /** Begins a turn at a monotonic time, ns. */
  void passTo(long timeNs) {
    nowNs = timeNs;
  }

  /** Sets who may come in; any thread. */
  void admit(EntryRule rule) {
    entryRule = rule;
  }

  /** Sets the password that newcomers must know; any thread. */
  void demand(GamePassword newPassword) {
    password = newPassword;
  }

  /** Returns the password that newcomers must know, or null for none. */
  GamePassword password() {
    return password;
  }

  /** Notes that a session's client stands by over a link, and ends the one before. */
  void standsBy(long secret, Visitor visitor) {
    standbys.values().removeIf(Visitor::isDone);
    Visitor before = standbys.put(secret, visitor);
    if (before != null) {
      before.replaced();
    }
  }

  /** Tells a client why it may not come in, and closes its link when that has arrived. */
  void sendRefusal(Link link, RefusalReason reason, String text) {
    LOG.info("refused: {}, {}{}", link.remote(), reason, text.isEmpty() ? "" : ", " + text);
    link.send(new ServerMessage.Refused(reason, text));
    closeLater(link, "refused: " + reason);
  }

  /** Closes a link a moment later, so that its last message arrives. */
  void closeLater(Link link, String why) {
    partings.add(link, why, nowNs + PARTING_MS * NS_PER_MS);
  }

  /** Returns the number of a room's seats that are kept for visitors other than one. */
  int countPromised(Room room, Visitor except) {
    int count = 0;
    for (int i = 0; i < visitors.size(); i++) {
      Visitor v = visitors.get(i);
      count += v != except && v.isPromised(room) ? 1 : 0;
    }
    return count;
  }

  /** Returns the number of visitors of a host that hold a seat and still load the level. */
  int countLoading(String host) {
    return countLoading(AddressGroup::host, host);
  }

  private int countLoading(Function<AddressGroup, String> group, String key) {
    int count = 0;
    for (int i = 0; i < visitors.size(); i++) {
      Visitor v = visitors.get(i);
      count += v.isLoading() && group.apply(v.origin()).equals(key) ? 1 : 0;
    }
    return count;
  }

  /**
   * Returns the visitor that must give up its seat when seats are short, or null. It is the oldest
   * visitor of the host that holds the most seats while loading, at least two. Without one it is
   * the oldest of the network that holds the most, more than {@value #LOADING_OF_NETWORK}. The
   * newcomer's own host or network is exempt. Without one it is the oldest that stalls.
   *
   * @param requested the room whose seats are short, or null for all
   */
  Visitor loaderToGiveWay(AddressGroup newcomer, Room requested) {
    Visitor ofHost = oldestOfBusiest(AddressGroup::host, 1, newcomer, requested);
    if (ofHost != null) {
      return ofHost;
    }
    Visitor ofNetwork =
        oldestOfBusiest(AddressGroup::network, LOADING_OF_NETWORK, newcomer, requested);
    return ofNetwork != null ? ofNetwork : oldestStalled(requested);
  }

  private Visitor oldestOfBusiest(
      Function<AddressGroup, String> group, int least, AddressGroup newcomer, Room requested) {
    Visitor oldest = null;
    int most = least;
    for (int i = 0; i < visitors.size(); i++) {
      Visitor v = visitors.get(i);
      String key = group.apply(v.origin());
      if (v.isLoading()
          && (requested == null || v.room() == requested)
          && !key.equals(group.apply(newcomer))) {
        int held = countLoading(group, key);
        if (held > most) { // the list is in order of arrival
          most = held;
          oldest = v;
        }
      }
    }
    return oldest;
  }

  private Visitor oldestStalled(Room requested) {
    for (int i = 0; i < visitors.size(); i++) {
      Visitor v = visitors.get(i);
      if (v.isStalled() && (requested == null || v.room() == requested)) {
        return v;
      }
    }
    return null;
  }
}
