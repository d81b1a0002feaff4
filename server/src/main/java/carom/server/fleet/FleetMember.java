package carom.server.fleet;

import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.server.access.SharedList;
import carom.server.command.SaveSource;
import carom.server.config.DataFolder;
import carom.server.config.RoomConfig;
import carom.server.directory.Directory;
import carom.server.directory.DirectoryException;
import carom.server.room.FleetDoor;
import carom.server.room.FleetRoom;
import carom.server.room.RoomOffer;
import carom.server.room.RoomSearch;
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
import java.util.concurrent.Future;
import java.util.concurrent.FutureTask;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A server's part in its fleet: it holds the server's lease and the claims of its rooms, tells the
 * directory about them, takes over rooms that have lost their owner, and shows the lobby the rooms
 * of the others.
 *
 * <p>{@link #turn} does what is due, on one thread, and never waits for a room. {@link FleetDoor}'s
 * methods are for any thread.
 */
public final class FleetMember implements FleetDoor, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(FleetMember.class);
  private static final long NS_PER_MS = 1_000_000;
  private static final long RENEW_NS = 400 * NS_PER_MS;
  private static final long PUBLISH_NS = 250 * NS_PER_MS;
  private static final long SERVER_NS = 4 * PUBLISH_NS;

  /** Time for which a claim may be this server's before it knows, ns: longer than any call. */
  private static final long STRAY_NS = 5_000 * NS_PER_MS;

  /** Most rooms with equal settings that a fleet can number. */
  private static final int MAX_NUMBERED = 100_000;

  /** Loads are told in steps of so many percent, so that entries rest while rooms do. */
  private static final int LOAD_STEP = 10;

  /** Steps in which this server's load is told, percent. */
  private static final int SHARE_STEP = 5;

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
  private final Tickets tickets;
  private final Parties parties;
  private final Following following;

  /** Rooms with which this server is about to go on. */
  private final Set<String> returning = ConcurrentHashMap.newKeySet();

  private final Set<Long> dead = ConcurrentHashMap.newKeySet();
  private final Runnable changed;

  /** Places that were promised since a room's owner told how many are taken. */
  private final Map<String, Promise> promised = new ConcurrentHashMap<>();

  private record Promise(int taken, int count) {}

  /** When rooms were first seen that are claimed by this server and aren't here. */
  private final Map<String, Long> strays = new HashMap<>();

  private FleetLists lists; // or null
  private volatile FleetSaves saves;
  private Peers peers;
  private volatile String peerAddress = "";
  private Followers followers;
  private Takeovers takeovers;
  private volatile RoomHost host; // null until the server has its rooms
  private volatile boolean draining;
  private volatile List<Looker> lookers = List.of();
  private final Balance balance = new Balance();
  private long renewNs;
  private long born; // the first lease
  private long serverNumber;
  private String serverTold = "";
  private volatile long serverNextNs;
  private long straysNextNs;
  private long clientsNextNs;
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
    tickets = new Tickets(this.directory);
    parties = new Parties(this.directory);
    following = new Following(settings.followed());
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
    peerAddress = address;
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
    born = born == 0 ? lease.number() : born;
    renewNs = askedNs + RENEW_NS;
    serverNumber = 0;
    tellServer(askedNs);
  }

  /**
   * Claims rooms before they are built. Rooms with names of their own that others have claimed are
   * left out. Numbered ones get the first numbers that are free in the fleet.
   *
   * @param wanted the server's own rooms
   * @param numbered whether they are equal, so that their names are numbers
   * @param step told whenever a room is claimed, or refused
   * @return the settings of the rooms that this server owns now
   * @throws DirectoryException if the directory doesn't answer
   */
  public List<RoomConfig> claim(List<RoomConfig> wanted, boolean numbered, Runnable step)
      throws DirectoryException {
    List<RoomConfig> owned = new ArrayList<>();
    int number = 0;
    for (RoomConfig room : wanted) {
      step.run();
      if (!numbered) {
        if (claims.make(room) != null) {
          owned.add(room);
        } else {
          LOG.info("fleet: room={} has another owner", room.name());
        }
        continue;
      }
      RoomConfig next;
      do {
        if (++number > MAX_NUMBERED) {
          throw new DirectoryException(
              "rooms=" + MAX_NUMBERED + " is all that a fleet numbers", null);
        }
        next = room.withName(String.valueOf(number)).withSeed(wanted.get(0).seed() + number - 1);
      } while (view.rooms().containsKey(next.name()) || claims.make(next) == null);
      owned.add(next);
    }
    return owned;
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
    followers =
        new Followers(claims, view, peers, newHost, lease, settings.durability(), asks, news);
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
    try {
      if (nowNs - renewNs >= 0 || isTakenForDead()) {
        renew();
      }
      if (lease.number() != 0 && host != null) {
        bury();
        takeovers.turn(nowNs, draining); // at once: their players wait
        tellServer(nowNs);
        Map<String, FleetRoom> rooms = new HashMap<>();
        host.rooms().forEach(room -> rooms.put(room.name(), room));
        if (!draining) {
          balance(host.rooms(), nowNs);
        }
        followers.turn(rooms, draining, nowNs);
        tellRooms(rooms, nowNs);
        forgetStrays(nowNs);
        tellClients(rooms, nowNs);
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
    return serverNumber != 0 && host != null && !view.servers().containsKey(lease.number());
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

  private void tellServer(long nowNs) throws DirectoryException {
    if (nowNs - serverNextNs < 0 && serverNumber != 0) {
      return;
    }
    serverNextNs = nowNs + SERVER_NS;
    ServerRecord record =
        new ServerRecord(
            lease.number(),
            born,
            settings.name(),
            settings.address(),
            settings.play(),
            settings.plain(),
            peerAddress,
            host == null ? 0 : stepped(share(host.rooms()), SHARE_STEP),
            lookers,
            draining);
    String value = record.toJson();
    if (serverNumber == 0) {
      serverNumber = directory.create(record.key(), value, lease.number());
      serverTold = value;
    } else if (!value.equals(serverTold)) {
      directory.update(record.key(), value, serverNumber);
      serverTold = value;
    }
  }

  /** Returns the part of this server's processors that the ticks of rooms take, percent. */
  private double share(List<? extends FleetRoom> rooms) {
    double share = 0;
    for (FleetRoom room : rooms) {
      share += room.loadPercent() / (double) settings.processors();
    }
    return Math.min(Balance.FULL_PERCENT, share);
  }

  private static int stepped(double load, int step) {
    return (int) load / step * step;
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
      if (takesRooms(server) && peers.isReached(server.lease())) {
        others.add(server);
      }
    }
    Balance.Move move = balance.next(loads, others, nowNs);
    Claims.Claim claim = move == null ? null : claims.of(move.room());
    if (claim != null) {
      LOG.info(
          "room={} moves to {}: load={} % here, {} % there",
          move.room(), move.to().name(), stepped(share(rooms), 1), move.to().load());
      claim.movesTo = move.to().lease();
    }
  }

  /** Tells the directory what has changed in the rooms, and releases those that are gone. */
  private void tellRooms(Map<String, FleetRoom> rooms, long nowNs) throws DirectoryException {
    for (Claims.Claim claim : claims.all()) {
      if (clock.getAsLong() - renewNs >= 0 || !dead.isEmpty()) {
        return; // where the directory is slow, the lease comes first, and rooms without an owner
      }
      if (nowNs - claim.nextNs < 0 || claim.handedOver) {
        continue;
      }
      FleetRoom room = rooms.get(claim.room());
      if (room == null || room.hasFailed()) {
        if (claim.nextNs != 0) { // it was there, and is gone
          claims.release(claim);
        }
        continue;
      }
      claim.nextNs = nowNs + PUBLISH_NS;
      RoomRecord record =
          new RoomRecord(
              lease.number(),
              room.isFollowed() ? claim.follower : 0,
              false,
              stepped(room.loadPercent(), LOAD_STEP),
              room.isFollowed()
                  ? room.followerLag() / RoomRecord.LAG_STEP * RoomRecord.LAG_STEP
                  : 0,
              room.parties().stream().limit(RoomRecord.MAX_PARTIES).toList(),
              accountsOf(room),
              room.offer().skill(),
              room.settings(),
              room.entry());
      String value = record.toJson();
      if (!value.equals(claim.told)) {
        if (directory.update(claim.key(), value, claim.number())) {
          claim.told = value;
        } else {
          lose(claim);
        }
      }
    }
  }

  private List<String> accountsOf(FleetRoom room) {
    return !settings.limitsSeats()
        ? List.of()
        : room.accounts().stream().limit(RoomRecord.MAX_ACCOUNTS).map(RoomRecord::hashed).toList();
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
    straysNextNs = nowNs + SERVER_NS;
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

  /** Tells the clients where to go if this server is lost. */
  private void tellClients(Map<String, FleetRoom> rooms, long nowNs) {
    if (nowNs - clientsNextNs < 0) {
      return;
    }
    clientsNextNs = nowNs + PUBLISH_NS;
    for (Link.Door door : Link.Door.values()) {
      List<String> addresses = new ArrayList<>();
      for (ServerRecord server : view.servers().values()) {
        String address = server.address(door);
        if (takesRooms(server)
            && !address.isEmpty()
            && addresses.size() < ProtocolLimits.MAX_FLEET_SERVERS) {
          addresses.add(address);
        }
      }
      for (Claims.Claim claim : claims.all()) {
        FleetRoom room = rooms.get(claim.room());
        ServerRecord follower = view.servers().get(claim.follower);
        boolean stands = follower != null && room != null && room.isFollowed();
        ServerMessage.Fleet message =
            new ServerMessage.Fleet(addresses, stands ? follower.address(door) : "");
        if (!message.equals(claim.ownership().servers(door))) {
          claim.ownership().servers(door, message);
        }
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
    serverNextNs = clock.getAsLong();
    changed.run();
  }

  /** Takes rooms and players again, and keeps the rooms that haven't gone. */
  private void undrain() {
    draining = false;
    claims.all().forEach(claim -> claim.movesTo = 0);
    serverNextNs = clock.getAsLong();
    changed.run();
  }

  /** Returns whether this server takes no more rooms and players. */
  public boolean isDraining() {
    return draining;
  }

  /** Returns whether no room of this server moves any longer: all are gone, or none can go. */
  public boolean isDrained() {
    return claims.all().isEmpty() || view.servers().values().stream().noneMatch(this::takesRooms);
  }

  private boolean takesRooms(ServerRecord server) {
    return server.lease() != lease.number() && !server.draining();
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
      serverNextNs = Math.min(serverNextNs, clock.getAsLong() + PUBLISH_NS);
      changed.run();
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
    return view.orphans().containsKey(room) || returning.contains(room);
  }

  @Override
  public boolean follows(String room, long secret) {
    return following.knows(room, secret);
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
              ? new ServerMessage.Move(server.address(), settings.fingerprint(), to.room(), ticket)
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
