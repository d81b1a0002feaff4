package carom.server.fleet;

import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.server.directory.Directory;
import carom.server.directory.DirectoryException;
import carom.server.room.FleetDoor;
import carom.server.room.RoomOffer;
import carom.server.room.RoomSearch;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.Future;
import java.util.concurrent.FutureTask;
import java.util.function.BiConsumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Finds places for players in the rooms of other servers, sends players there, and lets in those
 * that other servers send here. Any thread.
 */
final class Placement implements FleetDoor {
  private static final Logger LOG = LoggerFactory.getLogger(Placement.class);

  private final Directory directory;
  private final FleetSettings settings;
  private final FleetView view;
  private final Lease lease;
  private final Following following;
  private final Set<String> returning;
  private final Executor asks;
  private final BiConsumer<Long, PeerFrame> tells;
  private final Runnable lookersChanged;
  private final Tickets tickets;
  private final Parties parties;

  /** Places that were promised since a room's owner told how many are taken. */
  private final Map<String, Promise> promised = new ConcurrentHashMap<>();

  private record Promise(int taken, int count) {}

  private volatile List<Looker> lookers = List.of();

  /**
   * Creates an object that sends nobody anywhere yet.
   *
   * @param returning live names of rooms with which this server is about to go on
   * @param asks runs what waits for the directory or a server; may run it at once
   * @param tells tells a server something, if it can
   * @param lookersChanged told when {@link #lookers} changes; any thread, returns at once
   */
  Placement(
      Directory directory,
      FleetSettings settings,
      FleetView view,
      Lease lease,
      Following following,
      Set<String> returning,
      Executor asks,
      BiConsumer<Long, PeerFrame> tells,
      Runnable lookersChanged) {
    this.directory = directory;
    this.settings = settings;
    this.view = view;
    this.lease = lease;
    this.following = following;
    this.returning = returning;
    this.asks = asks;
    this.tells = tells;
    this.lookersChanged = lookersChanged;
    tickets = new Tickets(directory);
    parties = new Parties(directory);
  }

  /** Returns those who look for players about as good here, for the other servers. */
  List<Looker> lookers() {
    return lookers;
  }

  @Override
  public Place find(String room, Link.Door door) {
    FleetView.OwnedRoom there = view.rooms().get(room);
    return there != null && leadsTo(there.record(), door) ? place(there.record()) : null;
  }

  /** Returns whether a room is another server's, which has an address at a door. */
  private boolean leadsTo(RoomRecord record, Link.Door door) {
    ServerRecord server = view.servers().get(record.server());
    return record.server() != lease.number()
        && (door == Link.Door.OWN || (server != null && !server.address(door).isEmpty()));
  }

  private Place place(RoomRecord record) {
    return new Place(
        record.server(),
        record.settings().name(),
        new RoomOffer(
            record.entry().game(), taken(record), record.entry().places(), record.skill()));
  }

  /** Returns the seats that are taken, with those that were promised since the owner told. */
  private int taken(RoomRecord record) {
    int told = record.entry().players();
    Promise promise = promised.get(record.settings().name());
    return promise != null && promise.taken == told ? told + promise.count : told;
  }

  @Override
  public Place best(RoomSearch search, Link.Door door) {
    Place best = null;
    int most = -1;
    for (FleetView.OwnedRoom owned : view.rooms().values()) {
      RoomRecord record = owned.record();
      ServerRecord server = view.servers().get(record.server());
      if (!leadsTo(record, door)
          || server == null
          || server.draining()
          || (settings.maxLoadPercent() > 0 && record.load() > settings.maxLoadPercent())) {
        continue;
      }
      Place place = place(record);
      int fit = search.fit(place.offer());
      if (fit > most) {
        most = fit;
        best = place;
      }
    }
    return best;
  }

  @Override
  public void look(List<Looker> here) {
    boolean isLong = here.size() > ServerRecord.MAX_LOOKERS;
    List<Looker> told = isLong ? List.copyOf(here.subList(0, ServerRecord.MAX_LOOKERS)) : here;
    if (!told.equals(lookers)) {
      lookers = told;
      lookersChanged.run();
    }
  }

  @Override
  public List<Looker> lookersElsewhere() {
    List<Looker> elsewhere = new ArrayList<>();
    for (ServerRecord server : view.servers().values()) {
      if (server.lease() > lease.number()) {
        elsewhere.addAll(server.lookers());
      }
    }
    return elsewhere;
  }

  @Override
  public String roomOfParty(String party, Link.Door door) {
    for (FleetView.OwnedRoom owned : view.rooms().values()) {
      RoomRecord record = owned.record();
      if (record.parties().contains(party) && leadsTo(record, door)) {
        return record.settings().name();
      }
    }
    return null;
  }

  @Override
  public Future<String> settle(String party, String room) {
    return ask(() -> parties.settle(party, room));
  }

  @Override
  public int roomsOf(String account) {
    String hashed = RoomRecord.hashed(account);
    int count = 0;
    for (FleetView.OwnedRoom owned : view.rooms().values()) {
      RoomRecord record = owned.record();
      count += record.server() != lease.number() && record.accounts().contains(hashed) ? 1 : 0;
    }
    for (FleetView.Orphan orphan : view.orphans().values()) { // they go on in a moment
      count += orphan.record().accounts().contains(hashed) ? 1 : 0;
    }
    return count;
  }

  @Override
  public Future<Boolean> seats(String account) {
    return ask(
        () ->
            directory.create(HashedKey.of("seatings/", account), "", directory.lease(Lease.TTL_MS))
                != 0);
  }

  @Override
  public Future<Boolean> spend(String token, long seconds, boolean wasRead) {
    String key = HashedKey.of("spent/", token);
    int ttlMs = 1_000 * (int) Math.min(Integer.MAX_VALUE / 1_000, Math.max(2, seconds + 1));
    return ask(
        () ->
            wasRead
                ? directory.create(key, "", directory.lease(ttlMs)) != 0
                : directory.get(key) == null);
  }

  @Override
  public boolean mayComeBack(String room) {
    FleetView.OwnedRoom owned = view.rooms().get(room);
    boolean leaves = owned != null && owned.record().leaving();
    return leaves || view.orphans().containsKey(room) || returning.contains(room);
  }

  @Override
  public boolean follows(String room, long secret) {
    return following.knows(room, secret);
  }

  @Override
  public void standsBy(String room, long secret) {
    long owner = following.ownerOf(room);
    PeerFrame word = PeerFrame.of(PeerFrame.Kind.STANDS_BY, secret, room, new byte[0]);
    asks.execute(() -> tells.accept(owner, word));
  }

  @Override
  public Future<ServerMessage> move(Place to, Guest guest, Link.Door door) {
    FleetView.OwnedRoom there = view.rooms().get(to.room());
    if (there != null) {
      int told = there.record().entry().players();
      promised.merge(
          to.room(),
          new Promise(told, 1),
          (old, one) -> old.taken == told ? new Promise(told, old.count + 1) : one);
    }
    return ask(
        () -> {
          ServerRecord server = view.servers().get(to.server());
          if (server == null) {
            return null;
          }
          String ticket = tickets.make(to.server(), guest);
          return door == Link.Door.OWN
              ? server.move(settings.fingerprint(), to.room(), ticket)
              : server.redirect(door, to.room(), ticket);
        });
  }

  @Override
  public Future<Guest> redeem(String ticket) {
    return ask(() -> tickets.redeem(lease.number(), ticket));
  }

  /** Asks the directory for something. */
  private interface Question<T> {
    T answer() throws DirectoryException;
  }

  private <T> Future<T> ask(Question<T> question) {
    FutureTask<T> task =
        new FutureTask<>(
            () -> {
              try {
                return question.answer();
              } catch (DirectoryException e) {
                LOG.warn("fleet: {}", e.getMessage());
                return null;
              }
            });
    asks.execute(task);
    return task;
  }

  @Override
  public List<ServerMessage.RoomEntry> roomsElsewhere(Link.Door door) {
    List<ServerMessage.RoomEntry> entries = new ArrayList<>();
    for (FleetView.OwnedRoom owned : view.rooms().values()) {
      if (leadsTo(owned.record(), door)) {
        entries.add(owned.record().entry());
      }
    }
    return entries;
  }
}
