package carom.server.fleet;

import carom.server.checkpoint.SlotDisk;
import carom.server.config.ServerConfig.Durability;
import carom.server.directory.DirectoryException;
import carom.server.room.FleetRoom;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Gives each room of this server a follower, another server that has the room's journal, and moves
 * rooms: a room that moves gets the other server as its follower, ends here with its last tick, and
 * goes on there. The fleet's thread, but for {@link #move}.
 */
final class Followers implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Followers.class);

  /** Time between whole states of a journal, s. */
  private static final int STATE_S = 1;

  /** Time after which a follower that can't go on with a room is too slow for it, ns. */
  private static final long SLOW_NS = 3_000_000_000L;

  /** Longest time for which rooms wait for another one that moves, and for its clients, ns. */
  private static final long MOVE_NS = 1_000_000_000;

  /** Longest time for which a room that moves waits for its clients to stand by there, ns. */
  private static final long GATHER_NS = 5_000_000_000L;

  /** Time in which one room in {@link #FINDS} finds a follower, ns. */
  private static final long FIND_NS = 50_000_000;

  private static final int FINDS = 20;

  private final Claims claims;
  private final FleetView view;
  private final Peers peers;
  private final RoomHost host;
  private final Lease lease;
  private final FleetSettings settings;
  private final LongSupplier clock;
  private final Executor asks;
  private final FleetNews news;

  /** A room with players on its way to another server; {@code linked} tells of Carom's clients. */
  private record Departure(String name, FleetRoom room, boolean linked, long atNs) {}

  private final List<Departure> departures = new ArrayList<>();

  /** Rooms that are at other servers, whose clients haven't gone there yet. */
  private final Map<FleetRoom, Long> left = new ConcurrentHashMap<>();

  /** Rooms that each server owns and follows, as counted in the present turn; null before. */
  private Map<Long, Integer> burdens;

  /** Servers that own rooms in which people play, as seen in the present turn; null before. */
  private Set<Long> played;

  private boolean isBusy; // with rooms that come here
  private long findsNs; // begin of the present time in which rooms find followers
  private int found; // rooms in it

  private final Map<Long, SlotDisk> disks = new ConcurrentHashMap<>();

  Followers(
      Claims claims,
      FleetView view,
      Peers peers,
      RoomHost host,
      Lease lease,
      FleetSettings settings,
      LongSupplier clock,
      Executor asks,
      FleetNews news) {
    this.claims = claims;
    this.view = view;
    this.peers = peers;
    this.host = host;
    this.lease = lease;
    this.settings = settings;
    this.clock = clock;
    this.asks = asks;
    this.news = news;
  }

  /**
   * Does what is due.
   *
   * @param rooms of this server, by name
   * @param takesOver whether rooms come here now, for which players wait: new followers can wait
   */
  void turn(Map<String, FleetRoom> rooms, boolean draining, boolean takesOver, long nowNs) {
    isBusy = takesOver;
    burdens = null;
    played = null;
    for (ServerRecord server : view.servers().values()) {
      if (server.lease() != lease.number()) {
        peers.reach(server);
      }
    }
    for (long server : peers.reached()) {
      if (!view.servers().containsKey(server)) {
        peers.forget(server);
        SlotDisk disk = disks.remove(server);
        if (disk != null) {
          asks.execute(disk::close);
        }
      }
    }
    left.forEach((room, atNs) -> forgetClients(room, nowNs - atNs > MOVE_NS));
    departures.removeIf(one -> nowNs - one.atNs > MOVE_NS || isThere(one));
    List<Claims.Claim> all = new ArrayList<>(claims.all());
    all.sort(Comparator.comparing(claim -> -players(rooms.get(claim.room()))));
    boolean crowded = !all.isEmpty() && players(rooms.get(all.get(0).room())) > 0;
    for (Claims.Claim claim : all) {
      FleetRoom room = rooms.get(claim.room());
      if (room == null || claim.handedOver) {
        continue;
      }
      if (draining && claim.movesTo == 0) {
        ServerRecord best = best(claim, burdens());
        claim.movesTo = best == null ? 0 : best.lease();
      }
      if (claim.movesTo != 0 && !view.servers().containsKey(claim.movesTo)) {
        claim.movesTo = 0; // that server is gone
      }
      if (claim.movesTo != 0 && claim.follower == claim.movesTo && room.isFollowed()) {
        if (departures.size() < Math.max(1, settings.processors() / 2)
            && (players(room) > 0 || !(draining && crowded))
            && isGathered(claim, room, nowNs)) {
          if (players(room) > 0) {
            departures.add(new Departure(claim.room(), room, !room.linked().isEmpty(), nowNs));
          }
          handOver(claim, room);
        }
        continue;
      }
      findFollower(claim, room, nowNs);
    }
  }

  /**
   * Returns whether the clients of a room that moves stand by where it goes, so that it can speak
   * to them at once; or have had their time.
   */
  private static boolean isGathered(Claims.Claim claim, FleetRoom room, long nowNs) {
    if (claim.gathersNs == 0) {
      claim.gathersNs = nowNs;
    }
    return nowNs - claim.gathersNs > GATHER_NS || claim.standbys.containsAll(room.linked());
  }

  private static int players(FleetRoom room) {
    return room == null ? 0 : room.players();
  }

  /**
   * Returns whether a room's clients have gone to the other server, which has welcomed them then;
   * or, where it has only thin clients, whether that server has it. Others wait until then: more of
   * them than processors, side by side, would each take as long as all.
   */
  private boolean isThere(Departure one) {
    if (one.linked) {
      return one.room.linked().isEmpty();
    }
    FleetView.OwnedRoom there = view.rooms().get(one.name);
    return there != null && there.record().server() != lease.number() && there.record().isBuilt();
  }

  /** Closes the links of a room that was handed over, once its clients have gone, or now. */
  private void forgetClients(FleetRoom room, boolean now) {
    if (now || room.linked().isEmpty()) {
      room.closeClients();
      left.remove(room);
    }
  }

  /** Returns whether clients of rooms that are at other servers still have links here. */
  boolean hasClientsLeft() {
    return !left.isEmpty();
  }

  private void findFollower(Claims.Claim claim, FleetRoom room, long nowNs) {
    ServerRecord present = view.servers().get(claim.follower);
    boolean reached = present != null && peers.isReached(present.lease()) && !claim.unasked;
    if (claim.movesTo != 0) {
      if (!reached || claim.follower != claim.movesTo) {
        follow(claim, room, view.servers().get(claim.movesTo));
      }
      return;
    }
    if (settings.durability() == Durability.NONE) {
      follow(claim, room, null);
      return;
    }
    if (claim.follower == 0 || room.isFollowed()) {
      claim.followedNs = nowNs;
    }
    if (reached && nowNs - claim.followedNs > SLOW_NS) {
      claim.followedNs = nowNs;
      claim.slow = claim.follower;
      ServerRecord other = best(claim, burdens());
      if (other != null && other.lease() != claim.follower) {
        LOG.warn(
            "room={} is followed by {} instead of {}, which can't keep up",
            claim.room(),
            other.name(),
            present.name());
        follow(claim, room, other);
      }
    } else if (!reached || isLeaving(present)) {
      ServerRecord other = best(claim, burdens());
      if (other == null || takeTurn(nowNs)) {
        follow(claim, room, other);
      }
    }
  }

  /**
   * Returns whether a server that drains has handed its rooms over. Not before: all clients of the
   * rooms that it follows go on to stand by elsewhere, and those of its rooms would wait for them.
   */
  private boolean isLeaving(ServerRecord server) {
    if (server.draining() && played == null) {
      played = new HashSet<>();
      for (FleetView.OwnedRoom room : view.rooms().values()) {
        if (room.record().entry().players() > 0) {
          played.add(room.record().server());
        }
      }
    }
    return server.draining() && !played.contains(server.lease());
  }

  /**
   * Lets a room find a follower now, or says that others have come first: within a second all do,
   * one after the other, because the clients of each open a link to it.
   */
  private boolean takeTurn(long nowNs) {
    if (isBusy) {
      return false;
    }
    if (nowNs - findsNs >= FIND_NS) {
      findsNs = nowNs;
      found = 0;
    }
    return ++found <= 1 + claims.all().size() / FINDS;
  }

  /** Lets a server follow a room, or nobody. */
  private void follow(Claims.Claim claim, FleetRoom room, ServerRecord server) {
    if (server == null || !peers.isReached(server.lease())) {
      if (claim.follower != 0) {
        end(claim);
        claim.follower = 0;
        room.followedBy(null, null, STATE_S, false);
      }
      return;
    }
    end(claim);
    burdens().merge(claim.follower, -1, Integer::sum);
    burdens().merge(server.lease(), 1, Integer::sum);
    claim.standbys.clear();
    claim.gathersNs = 0;
    claim.follower = server.lease();
    claim.unasked = false;
    byte[] record = claim.told.getBytes(StandardCharsets.UTF_8);
    PeerFrame ask = PeerFrame.of(PeerFrame.Kind.FOLLOW, claim.number(), claim.room(), record);
    SlotDisk disk =
        disks.computeIfAbsent(server.lease(), number -> disk(room.tickRateHz(), server));
    disk.write(() -> claim.unasked = !peers.tell(server.lease(), ask));
    room.followedBy(
        disk,
        peers.journal(server, claim.room()),
        STATE_S,
        settings.durability() == Durability.SYNC);
  }

  /** Ends that the present follower follows a room. */
  private void end(Claims.Claim claim) {
    long former = claim.follower;
    SlotDisk disk = disks.get(former);
    if (disk != null && peers.isReached(former)) {
      PeerFrame end = PeerFrame.of(PeerFrame.Kind.END, 0, claim.room(), new byte[0]);
      disk.write(() -> peers.tell(former, end));
    }
  }

  private SlotDisk disk(int tickRateHz, ServerRecord server) {
    SlotDisk disk = SlotDisk.ofFollowers(tickRateHz);
    if (host.hasThreads()) {
      disk.start();
    }
    LOG.debug("fleet: journals go to {}", server.name());
    return disk;
  }

  /**
   * Returns the server that follows a room best: the present one, or that with the fewest rooms;
   * one that was too slow for it only if there is no other.
   */
  private ServerRecord best(Claims.Claim claim, Map<Long, Integer> rooms) {
    ServerRecord best = null;
    for (ServerRecord server : view.servers().values()) {
      if (server.lease() == lease.number()
          || server.draining()
          || !peers.isReached(server.lease())) {
        continue;
      }
      if (server.lease() == claim.follower && claim.follower != claim.slow) {
        return server;
      }
      boolean fewer =
          best == null
              || rooms.getOrDefault(server.lease(), 0) < rooms.getOrDefault(best.lease(), 0);
      if (best == null || best.lease() == claim.slow || (fewer && server.lease() != claim.slow)) {
        best = server;
      }
    }
    return best;
  }

  /** Returns how many rooms each server owns and follows, counted once in a turn. */
  private Map<Long, Integer> burdens() {
    burdens = burdens == null ? countBurdens() : burdens;
    return burdens;
  }

  private Map<Long, Integer> countBurdens() {
    Map<Long, Integer> rooms = new HashMap<>();
    for (FleetView.OwnedRoom room : view.rooms().values()) {
      rooms.merge(room.record().server(), 1, Integer::sum);
      if (room.record().server() != lease.number()) {
        rooms.merge(room.record().follower(), 1, Integer::sum);
      }
    }
    claims.all().forEach(own -> rooms.merge(own.follower, 1, Integer::sum));
    return rooms;
  }

  /**
   * Begins to move a room. Any thread.
   *
   * @param server name of the other server; empty for the best
   * @return name of that server
   * @throws IllegalArgumentException if the room must stay; the message says why
   */
  String move(Claims.Claim claim, String server) {
    ServerRecord to = null;
    if (server.isEmpty()) {
      to = best(claim, countBurdens());
    } else {
      for (ServerRecord other : view.servers().values()) {
        to = other.name().equals(server) && other.lease() != lease.number() ? other : to;
      }
    }
    if (to == null) {
      throw new IllegalArgumentException(
          server.isEmpty()
              ? "no other server of the fleet can take room=" + claim.room()
              : "server=" + server + " isn't another one of the fleet");
    }
    claim.movesTo = to.lease();
    return to.name();
  }

  private void handOver(Claims.Claim claim, FleetRoom room) {
    claim.handedOver = true;
    long to = claim.movesTo;
    ServerRecord server = view.servers().get(to);
    asks.execute(
        () -> {
          if (mayLeave(claim)) { // while the room still plays
            room.handOver(
                door -> server == null ? null : server.redirect(door, claim.room(), ""),
                () -> asks.execute(() -> giveAway(claim, room, to)));
          } else {
            claim.movesTo = 0;
            claim.handedOver = false;
          }
        });
  }

  private boolean mayLeave(Claims.Claim claim) {
    try {
      return claims.leave(claim);
    } catch (DirectoryException e) {
      LOG.error("room={} stays: {}", claim.room(), e.getMessage());
      return false;
    }
  }

  /** Gives a room that has ended here to its follower, who has all of it by then. */
  private void giveAway(Claims.Claim claim, FleetRoom room, long to) {
    try {
      SlotDisk disk = disks.get(to);
      if (disk == null || !disk.flush()) {
        throw new IOException("the end of its journal can't be sent");
      }
      peers.await(to);
      ServerRecord server = view.servers().get(to);
      if (server != null) { // the last word that the room may say
        room.sendOn(server.move(settings.fingerprint(), claim.room(), ""), claim.standbys);
      }
      claim.ownership().claim(0);
      peers.send(
          to, PeerFrame.of(PeerFrame.Kind.HAND_OVER, claim.number(), claim.room(), new byte[0]));
    } catch (IOException e) {
      LOG.error(
          "room={} is given up, and another server begins it: {}", claim.room(), e.toString());
    }
    try {
      claims.release(claim);
      LOG.info("moved room={} tick={}", claim.room(), room.tick());
      news.movedOut(claim.room(), view.nameOf(to));
    } catch (DirectoryException e) {
      LOG.error("room={} is released when the lease ends: {}", claim.room(), e.getMessage());
    }
    left.put(room, clock.getAsLong());
    host.forget(room);
  }

  @Override
  public void close() {
    left.keySet().forEach(FleetRoom::closeClients);
    disks.values().forEach(SlotDisk::close);
    disks.clear();
  }
}
