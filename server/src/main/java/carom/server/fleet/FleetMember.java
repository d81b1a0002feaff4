package carom.server.fleet;

import carom.server.access.SharedList;
import carom.server.command.SaveSource;
import carom.server.config.DataFolder;
import carom.server.config.RoomConfig;
import carom.server.directory.Directory;
import carom.server.directory.DirectoryEntry;
import carom.server.directory.DirectoryException;
import carom.server.room.FleetDoor;
import carom.server.room.FleetRoom;
import carom.server.session.Ownership;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A server's part in its fleet: it holds the server's lease and the claims of its rooms, tells the
 * directory about them, and takes over rooms that have lost their owner.
 *
 * <p>{@link #turn} does what is due, on one thread, and never waits for a room.
 */
public final class FleetMember implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(FleetMember.class);
  private static final long NS_PER_MS = 1_000_000;
  private static final long RENEW_NS = 400 * NS_PER_MS;
  private static final long PUBLISH_NS = 250 * NS_PER_MS;

  /** Time for which a claim may be this server's before it knows, ns: longer than any call. */
  private static final long STRAY_NS = 5_000 * NS_PER_MS;

  /** Most rooms with equal settings that a fleet can number. */
  private static final int MAX_NUMBERED = 100_000;

  private final CountedDirectory directory;
  private final FleetSettings settings;
  private final FleetNews news;
  private final FleetFigures figures;
  private final LongSupplier clock;
  private final Executor asks;
  private final Executor builds;
  private final Lease lease;
  private final Claims claims;
  private final FleetView view;
  private final Following following;
  private final Placement placement;
  private final Announcer announcer;

  /** Rooms with which this server is about to go on. */
  private final Set<String> returning = ConcurrentHashMap.newKeySet();

  private final Set<Long> dead = ConcurrentHashMap.newKeySet();
  private final Runnable changed;

  /** When rooms were first seen that are claimed by this server and aren't here. */
  private final Map<String, Long> strays = new HashMap<>();

  private FleetLists lists; // or null
  private volatile FleetSaves saves;
  private Peers peers;
  private Followers followers;
  private Takeovers takeovers;
  private volatile RoomHost host; // null until the server has its rooms
  private volatile boolean draining;
  private int owned; // rooms, in the last turn
  private volatile long changedNs; // when that was another number last, or a drain began
  private final Balance balance = new Balance();
  private long renewNs;
  private long straysNextNs;
  private long listsNextNs;
  private boolean away;
  private volatile boolean closed;

  /**
   * Creates a member that hasn't joined.
   *
   * @param directory stays the caller's to close, after this
   * @param clock monotonic nanoseconds
   * @param asks runs what waits for the directory or a room; may run it at once
   * @param builds runs what builds a room, in order; may run it at once
   * @param changed told when {@link #turn} should come soon; any thread, returns at once
   */
  public FleetMember(
      Directory directory,
      FleetSettings settings,
      LongSupplier clock,
      Executor asks,
      Executor builds,
      Runnable changed) {
    this.directory = new CountedDirectory(directory);
    this.settings = settings;
    this.clock = clock;
    this.asks = asks;
    this.builds = builds;
    this.changed = changed;
    lease = new Lease(clock, settings.keepsRooms());
    news = new FleetNews(clock, settings.name());
    claims = new Claims(this.directory, lease, news);
    view = new FleetView(directory, clock, changed, news);
    following = new Following(settings.followed());
    placement =
        new Placement(
            this.directory,
            settings,
            view,
            lease,
            following,
            returning,
            asks,
            (server, frame) -> peers.tell(server, frame),
            this::lookersChanged);
    announcer = new Announcer(this.directory, settings, clock, lease, claims, view, placement);
    figures =
        new FleetFigures(
            view,
            claims,
            following,
            lease,
            this.directory,
            news,
            clock,
            () -> host == null ? List.of() : host.rooms());
  }

  /** Returns what hears other servers. */
  public Peers.Inbox inbox() {
    return new Peers.Inbox() {
      @Override
      public void take(long server, PeerFrame frame) throws IOException {
        if (frame.kind() == PeerFrame.Kind.STANDS_BY) {
          standsBy(server, frame);
          return;
        }
        following.take(server, frame);
        if (frame.kind() == PeerFrame.Kind.HAND_OVER) {
          changed.run();
        }
      }

      @Override
      public PeerFrame answer(PeerFrame line) {
        if (line.kind() == PeerFrame.Kind.SAVED) {
          return saves.answer(line);
        }
        String answer;
        boolean done;
        try {
          answer = runHere(List.of(new String(line.bytes(), StandardCharsets.UTF_8).split(" ")));
          done = true;
        } catch (IllegalArgumentException e) {
          answer = e.getMessage();
          done = false;
        }
        byte[] text = answer.getBytes(StandardCharsets.UTF_8);
        return PeerFrame.of(PeerFrame.Kind.ANSWER, done ? 0 : 1, "", text);
      }

      @Override
      public void lost(long server) {
        following.lost(server);
        changed.run();
      }

      @Override
      public void dead(long server) {
        dead.add(server);
        changed.run();
      }
    };
  }

  /**
   * Sets how this server reaches the others; before {@link #join}.
   *
   * @param address where they reach this one, {@code host:port}
   */
  public void reachesBy(Peers newPeers, String address) {
    peers = newPeers;
    announcer.reachedAt(address);
  }

  /**
   * Keeps lists the same on all servers of the fleet; before {@link #join}.
   *
   * @param folder gets what the servers agreed on last
   * @throws IOException if a file in the folder can't be read
   */
  void shares(Path folder, List<SharedList> shared) throws IOException {
    lists = new FleetLists(directory, folder, shared);
  }

  /** Finds saves in a data folder, for this server and the others; before {@link #join}. */
  void keepsSaves(DataFolder data) {
    saves = new FleetSaves(data, view, peers, lease);
  }

  /** Returns what shows the rest of the fleet to lobby and rooms. */
  public FleetDoor door() {
    return placement;
  }

  /** Learns that a client of one of this server's rooms stands by at another server. */
  private void standsBy(long server, PeerFrame frame) {
    Claims.Claim claim = claims.of(frame.room());
    if (claim != null && claim.follower == server) {
      claim.standbys.add(frame.number());
      FleetRoom room = host == null ? null : host.room(frame.room());
      if (room != null && claim.standbys.size() > 2 * room.entry().places()) {
        claim.standbys.retainAll(room.linked()); // players come and go for weeks
      }
      changed.run();
    }
  }

  private void lookersChanged() {
    announcer.soon(PUBLISH_NS);
    changed.run();
  }

  /** Returns the saves of the other servers. */
  public SaveSource saves() {
    return saves;
  }

  /** Returns this server's number in the fleet, 0 while it has none. */
  public long number() {
    return lease.number();
  }

  /**
   * Joins the fleet, with the lease under which this server claims its rooms.
   *
   * @throws DirectoryException if the directory doesn't answer
   */
  public void join() throws DirectoryException {
    long askedNs = clock.getAsLong();
    lease.renewed(directory.lease(Lease.TTL_MS), askedNs);
    renewNs = askedNs + RENEW_NS;
    announcer.begin();
    announcer.tellServer(host, draining, askedNs);
  }

  /**
   * Claims rooms before they are built. Rooms with names of their own that others have claimed are
   * left out. Of numbered ones only as many are claimed as the fleet lacks, with the first numbers
   * that are free there: the rooms of a server that was started again have gone to others.
   *
   * @param wanted the server's own rooms
   * @param numbered whether they are equal, so that their names are numbers
   * @param step told whenever a room is claimed, or refused
   * @return the settings of the rooms that this server owns now
   * @throws DirectoryException if the directory doesn't answer
   */
  public List<RoomConfig> claim(List<RoomConfig> wanted, boolean numbered, Runnable step)
      throws DirectoryException {
    return numbered ? claimNumbered(wanted, step) : claimNamed(wanted, step);
  }

  private List<RoomConfig> claimNamed(List<RoomConfig> wanted, Runnable step)
      throws DirectoryException {
    List<RoomConfig> owned = new ArrayList<>();
    for (RoomConfig room : wanted) {
      step.run();
      if (claims.make(room) != null) {
        owned.add(room);
      } else {
        LOG.info("fleet: room={} has another owner", room.name());
      }
    }
    return owned;
  }

  private List<RoomConfig> claimNumbered(List<RoomConfig> wanted, Runnable step)
      throws DirectoryException {
    RoomConfig first = wanted.get(0);
    String kind = RoomRecord.kind(first);
    announcer.startedFor(kind, wanted.size());
    announcer.tellServer(host, draining, clock.getAsLong()); // so that others count on it
    int lacking = Math.min(wanted.size(), lacking(kind));
    if (lacking < wanted.size()) {
      LOG.info("fleet: begins rooms={} of {}: the fleet has the others", lacking, wanted.size());
    }
    List<RoomConfig> owned = new ArrayList<>();
    int number = 0;
    while (owned.size() < lacking) {
      step.run();
      RoomConfig next;
      do {
        if (++number > MAX_NUMBERED) {
          throw new DirectoryException(
              "rooms=" + MAX_NUMBERED + " is all that a fleet numbers", null);
        }
        next = first.withName(String.valueOf(number)).withSeed(first.seed() + number - 1);
      } while (view.rooms().containsKey(next.name()) || claims.make(next) == null);
      owned.add(next);
    }
    return owned;
  }

  /** Returns how many rooms of a kind the fleet has fewer than its servers were started for. */
  private int lacking(String kind) throws DirectoryException {
    int lacking = 0;
    // Rooms first, so that each room's owner is among the servers.
    for (DirectoryEntry room : directory.list(RoomRecord.PREFIX)) {
      try {
        lacking -= RoomRecord.parse(room.value()).isOfKind(kind) ? 1 : 0;
      } catch (IOException e) {
        LOG.debug("fleet: {} isn't counted: {}", room.key(), e.getMessage());
      }
    }
    for (DirectoryEntry entry : directory.list(ServerRecord.PREFIX)) {
      try {
        long number = Long.parseLong(entry.key().substring(ServerRecord.PREFIX.length()));
        ServerRecord server = ServerRecord.parse(number, entry.value());
        // Another one at the same address is this one before it was started again.
        boolean isThere = number == lease.number() || !server.address().equals(settings.address());
        lacking += isThere && !server.draining() && server.kind().equals(kind) ? server.rooms() : 0;
      } catch (IOException | NumberFormatException e) {
        LOG.debug("fleet: {} isn't counted: {}", entry.key(), e.getMessage());
      }
    }
    return Math.max(0, lacking);
  }

  /**
   * Returns the ownership of a room that is about to be built, which this server claims if it
   * hasn't yet.
   *
   * @throws IllegalArgumentException if the room belongs to another server
   */
  public Ownership ownershipOf(RoomConfig room) {
    try {
      Claims.Claim claim = claims.of(room.name());
      claim = claim == null ? claims.make(room) : claim;
      if (claim != null) {
        return claim.ownership();
      }
    } catch (DirectoryException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
    throw new IllegalArgumentException(
        "room=" + room.name() + " belongs to another server of the fleet");
  }

  /** Sets whose rooms these are. */
  public void serves(RoomHost newHost) {
    followers = new Followers(claims, view, peers, newHost, lease, settings, clock, asks, news);
    takeovers =
        new Takeovers(
            claims, view, following, newHost, lease, clock, asks, builds, returning, changed, news);
    host = newHost;
  }

  /** Returns whether the member has rooms to serve. */
  boolean isServing() {
    return host != null;
  }

  /** Does what is due: before {@link #serves}, only the lease is. One thread. */
  public void turn(long nowNs) {
    if (closed) {
      return;
    }
    if (claims.all().size() != owned) {
      owned = claims.all().size();
      changedNs = nowNs;
    }
    try {
      if (nowNs - renewNs >= 0 || isTakenForDead()) {
        renew();
      }
      if (lease.number() != 0 && host != null) {
        bury();
        takeovers.turn(nowNs, draining); // at once: their players wait
        announcer.tellServer(host, draining, nowNs);
        Map<String, FleetRoom> rooms = new HashMap<>();
        host.rooms().forEach(room -> rooms.put(room.name(), room));
        if (!draining) {
          balance(host.rooms(), nowNs);
        }
        followers.turn(rooms, draining, !returning.isEmpty(), nowNs);
        announcer.tellRooms(rooms, nowNs, this::isHindered, this::lose);
        forgetStrays(nowNs);
        announcer.tellClients(rooms, nowNs);
        if (lists != null && nowNs - listsNextNs >= 0) {
          listsNextNs = nowNs + 2 * PUBLISH_NS;
          asks.execute(lists::agree);
        }
      }
      if (away) {
        away = false;
        LOG.info("fleet: the directory answers again");
        news.tell("the directory answers again");
      }
    } catch (DirectoryException e) {
      if (!away) {
        away = true;
        LOG.error("fleet: {}; {}", e.getMessage(), settings.onPartition());
        news.tell("the directory doesn't answer");
      }
      renewNs = clock.getAsLong(); // again in the next turn
    }
  }

  /**
   * Returns whether another server may have ended this one's lease, because it took this server for
   * dead: then this one knows before it renews again that its rooms are others'.
   */
  private boolean isTakenForDead() {
    return announcer.isKnown() && host != null && !view.servers().containsKey(lease.number());
  }

  private void renew() throws DirectoryException {
    long askedNs = clock.getAsLong();
    boolean held = lease.getAsBoolean();
    if (lease.number() != 0 && directory.renew(lease.number())) {
      lease.renewed(lease.number(), askedNs);
      renewNs = askedNs + RENEW_NS;
      if (!held && host != null) {
        host.rooms().forEach(FleetRoom::ownershipChanged); // they stand still, and sleep
      }
      return;
    }
    if (lease.number() != 0) {
      LOG.error("fleet: the lease is over; rooms stand still until they are claimed again");
      lease.ended();
      peers.reached().forEach(peers::forget);
    }
    join();
    if (takeovers != null) {
      takeovers.cameBack(clock.getAsLong());
    }
    for (Claims.Claim claim : claims.all()) {
      claim.follower = 0;
      if (!claims.renew(claim)) {
        lose(claim);
      }
    }
    if (host != null) {
      host.rooms().forEach(FleetRoom::ownershipChanged);
    }
  }

  /** Returns whether the lease must be renewed, or rooms without an owner wait. */
  private boolean isHindered() {
    return clock.getAsLong() - renewNs >= 0 || !dead.isEmpty();
  }

  private void lose(Claims.Claim claim) {
    claims.lose(claim);
    FleetRoom room = host == null ? null : host.room(claim.room());
    if (room != null) {
      host.drop(room, "another server owns room " + claim.room());
    }
  }

  /** Ends the leases of servers whose processes are dead, so that nobody waits for them. */
  private void bury() throws DirectoryException {
    for (long server : Set.copyOf(dead)) {
      view.bury(server);
      if (view.servers().containsKey(server)) {
        LOG.warn("fleet: server {} is dead", view.servers().get(server).name());
        directory.revoke(server);
        view.revoked(server);
      }
      dead.remove(server);
    }
  }

  /** Gives a room to a server that has less to do, if this one has much to do. */
  private void balance(List<? extends FleetRoom> rooms, long nowNs) {
    Map<String, Double> loads = new HashMap<>();
    for (FleetRoom room : rooms) {
      Claims.Claim claim = claims.of(room.name());
      if (claim != null && claim.movesTo != 0) {
        return; // one at a time
      }
      loads.put(room.name(), room.loadPercent() / (double) settings.processors());
    }
    List<ServerRecord> others = new ArrayList<>();
    for (ServerRecord server : view.servers().values()) {
      if (server.takesRoomsOf(lease.number()) && peers.isReached(server.lease())) {
        others.add(server);
      }
    }
    Balance.Move move = balance.next(loads, others, nowNs);
    Claims.Claim claim = move == null ? null : claims.of(move.room());
    if (claim != null) {
      LOG.info(
          "room={} moves to {}: load={} % here, {} % there",
          move.room(),
          move.to().name(),
          Announcer.stepped(announcer.share(rooms), 1),
          move.to().load());
      claim.movesTo = move.to().lease();
    }
  }

  /**
   * Gives up what this server has by mistake: rooms whose claim was lost while they were built, and
   * claims of which it never heard that they were made, because the directory's answer was lost.
   */
  private void forgetStrays(long nowNs) throws DirectoryException {
    for (FleetRoom room : host.rooms()) {
      if (claims.of(room.name()) == null && !room.isClosed()) {
        host.drop(room, "this server doesn't own room " + room.name());
      }
    }
    if (nowNs - straysNextNs < 0) {
      return; // the fleet may have ten thousand rooms
    }
    straysNextNs = nowNs + 4 * PUBLISH_NS;
    for (Map.Entry<String, FleetView.OwnedRoom> one : view.rooms().entrySet()) {
      FleetView.OwnedRoom owned = one.getValue();
      if (owned.record().server() != lease.number() || claims.of(one.getKey()) != null) {
        strays.remove(one.getKey());
      } else if (nowNs - strays.computeIfAbsent(one.getKey(), room -> nowNs) > STRAY_NS) {
        LOG.warn("fleet: room={} was claimed by this server and isn't here", one.getKey());
        directory.delete(RoomRecord.key(one.getKey()), owned.claim());
        strays.remove(one.getKey());
      }
    }
  }

  /** Returns the fleet as this server sees it. */
  public FleetFigures figures() {
    return figures;
  }

  /**
   * Does what an operator says, see {@link FleetVerb}; without a name, a server is this one. What
   * concerns another server is told to that one, which may take seconds. Any thread.
   *
   * @return the answer, perhaps of several lines
   * @throws IllegalArgumentException if it can't be done; the message says why
   */
  public String run(List<String> words) {
    FleetVerb verb = FleetVerb.of(words);
    if (words.size() < 2) {
      return runHere(words);
    }
    try {
      FleetCommands.Snapshot snapshot = new FleetCommands.Snapshot(view);
      boolean moves = verb == FleetVerb.MOVE;
      ServerRecord server = moves ? snapshot.owner(words.get(1)) : snapshot.server(words.get(1));
      if (server.lease() == lease.number()) {
        return runHere(words);
      }
      String line = moves ? String.join(" ", words) : verb.word();
      PeerFrame answer = peers.ask(server, Peers.command(line));
      return server.name() + ": " + Peers.words(server, answer);
    } catch (IOException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  private String runHere(List<String> words) {
    FleetCommands.Snapshot snapshot = new FleetCommands.Snapshot(view);
    return switch (FleetVerb.of(words)) {
      case STATUS -> snapshot.status();
      case ROOMS -> snapshot.roomList();
      case MOVE -> {
        if (words.size() < 2) {
          throw new IllegalArgumentException("name the room: " + FleetVerb.MOVE.usage());
        }
        yield move(words.get(1), words.size() > 2 ? words.get(2) : "");
      }
      case DRAIN -> {
        drain();
        yield "drains: its rooms move to the other servers";
      }
      case UNDRAIN -> {
        undrain();
        yield "takes rooms and players again";
      }
    };
  }

  private String move(String room, String server) {
    Claims.Claim claim = claims.of(room);
    if (claim == null) {
      throw new IllegalArgumentException("room=" + room + " isn't this server's");
    }
    String to = followers.move(claim, server);
    changed.run();
    return "room=" + room + " moves to " + to;
  }

  /** Takes no more rooms and players, and begins to move all rooms away. */
  public void drain() {
    draining = true;
    changedNs = clock.getAsLong();
    announcer.soon(0);
    changed.run();
  }

  /** Takes rooms and players again, and keeps the rooms that haven't gone. */
  private void undrain() {
    draining = false;
    claims.all().forEach(claim -> claim.movesTo = 0);
    announcer.soon(0);
    changed.run();
  }

  /** Returns whether this server takes no more rooms and players. */
  public boolean isDraining() {
    return draining;
  }

  /** Returns for how long no room has come or gone since a drain began, ns. */
  long stillNs() {
    return clock.getAsLong() - changedNs;
  }

  /**
   * Returns whether the fleet can do without this server: its rooms and their clients are gone, or
   * none can go, and it follows none of the others' as they tell.
   */
  public boolean isDrained() {
    boolean isNeeded =
        !claims.all().isEmpty()
            || (followers != null && followers.hasClientsLeft())
            || view.rooms().values().stream()
                .anyMatch(room -> room.record().follower() == lease.number());
    return !isNeeded
        || view.servers().values().stream()
            .noneMatch(server -> server.takesRoomsOf(lease.number()));
  }

  /** Leaves the fleet: the lease ends, and with it the claims. */
  @Override
  public void close() {
    closed = true;
    long number = lease.number();
    lease.ended();
    try {
      if (number != 0) {
        directory.revoke(number);
      }
    } catch (DirectoryException e) {
      LOG.warn("fleet: the lease ends by itself: {}", e.getMessage());
    }
    peers.close();
    if (followers != null) {
      followers.close();
    }
  }
}
