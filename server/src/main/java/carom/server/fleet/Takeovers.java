package carom.server.fleet;

import carom.server.config.RoomConfig;
import carom.server.directory.DirectoryException;
import carom.server.room.FleetRoom;
import carom.server.session.Ownership;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Goes on with rooms that have lost their owner, and with those that another server hands over. The
 * follower comes first, then the server with the fewest rooms. The fleet's thread.
 */
final class Takeovers {
  private static final Logger LOG = LoggerFactory.getLogger(Takeovers.class);
  private static final long NS_PER_MS = 1_000_000;

  /** Time that a better candidate has to take over a room before the next one tries, ns. */
  private static final long RANK_NS = 300 * NS_PER_MS;

  /**
   * Time that an owner has to claim its room again, and a follower that is alive, ns: another
   * server would have to begin the room anew.
   */
  private static final long OWNER_NS = 5_000 * NS_PER_MS;

  /**
   * Time that others have to come back, too, after this server lost its lease, ns: mostly the
   * directory was away for all, and then the owners still have their rooms.
   */
  private static final long RETURN_NS = 3_000 * NS_PER_MS;

  /** Time that the rest of a dead owner's journal has to come out of the socket, ns. */
  private static final long REST_NS = 100 * NS_PER_MS;

  private final Claims claims;
  private final FleetView view;
  private final Following following;
  private final RoomHost host;
  private final Lease lease;
  private final LongSupplier clock;
  private final Executor asks;
  private final Executor builds;
  private final Runnable changed;
  private final FleetNews news;
  private final Set<String> underWay;
  private final AtomicBoolean prepares = new AtomicBoolean();
  private long patientUntilNs = Long.MIN_VALUE;

  /**
   * Creates an object that has nothing to do yet.
   *
   * @param underWay gets the names of rooms with which this server is about to go on; any thread
   */
  Takeovers(
      Claims claims,
      FleetView view,
      Following following,
      RoomHost host,
      Lease lease,
      LongSupplier clock,
      Executor asks,
      Executor builds,
      Set<String> underWay,
      Runnable changed,
      FleetNews news) {
    this.claims = claims;
    this.view = view;
    this.following = following;
    this.host = host;
    this.lease = lease;
    this.clock = clock;
    this.asks = asks;
    this.builds = builds;
    this.underWay = underWay;
    this.changed = changed;
    this.news = news;
  }

  /** Learns that this server has a lease again. */
  void cameBack(long nowNs) {
    patientUntilNs = nowNs + RETURN_NS;
  }

  /** Does what is due: rooms with players first, as they wait, and then the others. */
  void turn(long nowNs, boolean draining) {
    Map<String, RoomRecord> due = new HashMap<>();
    for (Map.Entry<String, Following.Followed> one : following.rooms().entrySet()) {
      FleetView.OwnedRoom owned = view.rooms().get(one.getKey());
      boolean isFree = owned == null; // no sooner: each try in vain is a write to etcd's disk
      if (one.getValue().isHandedOver() && isFree) {
        due.put(one.getKey(), one.getValue().record());
      } else if (owned != null
          && owned.claim() > one.getValue().claim()
          && !underWay.contains(one.getKey())) {
        following.end(one.getKey()); // another server has gone on with it
      }
    }
    if (!draining) {
      findOrphans(nowNs, due);
    }
    List<Map.Entry<String, RoomRecord>> inOrder = new ArrayList<>(due.entrySet());
    inOrder.sort(Comparator.comparing(one -> -one.getValue().entry().players()));
    boolean crowded = !underWay.isEmpty();
    for (Map.Entry<String, RoomRecord> one : inOrder) {
      boolean hasPlayers = one.getValue().entry().players() > 0;
      crowded |= hasPlayers;
      if (hasPlayers || !crowded) {
        begin(one.getKey(), one.getValue());
      }
    }
    if (due.isEmpty() && underWay.isEmpty()) {
      following.rooms().forEach(this::prepare);
    }
  }

  /** Builds a followed room in which people play in advance, one room at a time. */
  private void prepare(String name, Following.Followed followed) {
    FleetView.OwnedRoom owned = view.rooms().get(name);
    if (owned == null
        || owned.record().entry().players() == 0
        || followed.match() == 0
        || followed.isPrepared(owned.record().settings())
        || !prepares.compareAndSet(false, true)) {
      return;
    }
    RoomConfig settings = owned.record().settings();
    builds.execute(
        () -> {
          int match = followed.match();
          try {
            FleetRoom room = host.prepare(settings, followed.folder(), claims.unclaimed());
            followed.prepared(new Following.Prepared(room, match));
          } catch (IllegalArgumentException e) {
            LOG.debug("room={} isn't built in advance: {}", name, e.getMessage());
            followed.prepared(new Following.Prepared(null, match));
          } finally {
            prepares.set(false);
          }
        });
  }

  /** Adds the rooms that have lost their owner, if it is this server's turn to go on with them. */
  private void findOrphans(long nowNs, Map<String, RoomRecord> due) {
    Map<String, FleetView.Orphan> orphans = view.orphans();
    List<Long> able = orphans.isEmpty() ? List.of() : able();
    for (Map.Entry<String, FleetView.Orphan> one : orphans.entrySet()) {
      FleetView.Orphan orphan = one.getValue();
      RoomRecord record = orphan.record();
      boolean ownerMayReturn =
          !record.leaving()
              && (view.having(record.server()) != null
                  || (nowNs < patientUntilNs && view.mayReturn(record.server())));
      long waitedNs = nowNs - orphan.sinceNs();
      boolean ownerIsGone = !ownerMayReturn || waitedNs >= OWNER_NS;
      boolean restIsHere = !following.hears(record.server()) || waitedNs >= REST_NS;
      if (ownerIsGone && restIsHere && waitedNs >= patienceNs(record, able)) {
        due.put(one.getKey(), orphan.record());
      }
    }
  }

  /** Claims a room, which waits for the directory, and then builds it, which takes a processor. */
  private void begin(String room, RoomRecord record) {
    if (claims.of(room) == null && underWay.add(room)) {
      asks.execute(
          () -> {
            Following.Followed followed = following.usable(room); // before anybody hears of it
            FleetView.Orphan orphan = view.orphans().get(room);
            long lostNs = orphan == null ? clock.getAsLong() : orphan.sinceNs();
            FleetRoom prepared = followed == null ? null : followed.takePrepared(record.settings());
            Ownership ownership = prepared == null ? claims.unclaimed() : prepared.ownership();
            Claims.Claim claim = null;
            try {
              claim = claims.make(record.settings(), ownership);
            } catch (DirectoryException e) {
              LOG.warn("fleet: room={} can't be claimed: {}", room, e.getMessage());
            }
            if (claim == null) { // or another server was faster, or the owner is still there
              end(room);
              return;
            }
            Claims.Claim own = claim;
            builds.execute(
                () -> {
                  try {
                    goOn(record, own, followed, prepared, lostNs);
                  } finally {
                    end(room);
                  }
                });
          });
    }
  }

  private void end(String room) {
    underWay.remove(room);
    changed.run();
  }

  /** Goes on with a room that was lost at a time, and perhaps was built before. */
  private void goOn(
      RoomRecord record,
      Claims.Claim claim,
      Following.Followed followed,
      FleetRoom prepared,
      long lostNs) {
    String name = claim.room();
    long beginNs = clock.getAsLong();
    try {
      Path slots = followed == null ? null : followed.folder();
      FleetRoom room =
          prepared == null ? host.prepare(record.settings(), slots, claim.ownership()) : prepared;
      host.takeOver(room, slots);
      LOG.info(
          "took over room={} claim={} tick={} lost={}{}",
          name,
          claim.number(),
          room.tick(),
          followed == null ? "all" : room.lostTicks(),
          followed == null ? ": nobody has followed it" : "");
      if (record.leaving() || (followed != null && followed.isHandedOver())) {
        news.movedIn(name, claim.number());
      } else {
        news.tookOver(name, claim.number(), room.tick(), clock.getAsLong() - lostNs);
      }
      LOG.debug("room {} is here after {} ms", name, (clock.getAsLong() - beginNs) / NS_PER_MS);
    } catch (IllegalArgumentException e) {
      LOG.error("room={} can't go on here: {}", name, e.getMessage());
      release(claim);
    } finally { // not before: clients that stand by wait for the room as long as it is followed
      following.end(name);
      view.orphans().remove(name);
    }
  }

  private void release(Claims.Claim claim) {
    try {
      claims.release(claim);
    } catch (DirectoryException e) {
      LOG.warn("fleet: room={} stays claimed: {}", claim.room(), e.getMessage());
    }
  }

  /**
   * Returns how long this server lets others go on with a room, ns.
   *
   * @param able the servers that may, as {@link #able} returns them
   */
  private long patienceNs(RoomRecord record, List<Long> able) {
    ServerRecord follower = view.having(record.follower());
    boolean waits = follower != null && follower.lease() != lease.number();
    int self = able.indexOf(lease.number());
    int first = follower == null ? -1 : able.indexOf(follower.lease()); // others move on by one
    int rank = self < 0 ? able.size() : self == first ? 0 : self < first ? self + 1 : self;
    return rank * RANK_NS + (waits ? OWNER_NS : 0);
  }

  /** Returns the servers that may take rooms over, those with the fewest rooms first. */
  private List<Long> able() {
    Map<Long, Integer> owned = new HashMap<>();
    view.rooms().values().forEach(room -> owned.merge(room.record().server(), 1, Integer::sum));
    return view.servers().values().stream()
        .filter(server -> !server.draining())
        .map(ServerRecord::lease)
        .sorted(
            Comparator.comparing((Long server) -> owned.getOrDefault(server, 0))
                .thenComparing(Comparator.naturalOrder()))
        .toList();
  }
}
