package carom.lab.fleet;

import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.physics.math.SimRandom;
import carom.server.account.PlayerSkill;
import carom.server.checkpoint.SlotDisk;
import carom.server.checkpoint.SlotLink;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig.Durability;
import carom.server.directory.MemoryDirectory;
import carom.server.fleet.FleetMember;
import carom.server.fleet.FleetSettings;
import carom.server.fleet.PeerFrame;
import carom.server.fleet.Peers;
import carom.server.fleet.RoomHost;
import carom.server.fleet.ServerRecord;
import carom.server.room.FillUp;
import carom.server.room.FleetDoor;
import carom.server.room.FleetRoom;
import carom.server.room.RoomOffer;
import carom.server.session.Ownership;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;

/**
 * A large fleet in virtual time, of which everything runs but the rooms: those are a name and a
 * number of players, whose journals cost nothing. Players come to any server and get a room as a
 * lobby would find it. One thread does everything.
 */
final class ToyFleet implements AutoCloseable {
  /** Time of a step; a server of a real fleet does its turns at least so often. */
  private static final long STEP_NS = 25_000_000;

  /** Most turns of a server in a step, if others change what it has to know. */
  private static final int MOST_ROUNDS = 20;

  /** Most servers to which a player goes whose room has filled up meanwhile. */
  private static final int MOST_TRIES = 5;

  private static final double NS_PER_S = 1e9;
  private static final FillUp ANY = new FillUp("", false);
  private static final String GAME = "toy";

  private final MemoryDirectory directory = new MemoryDirectory(this::now);
  private final Map<String, Node> nodes = new LinkedHashMap<>();
  private final Map<String, Integer> players = new HashMap<>();
  private final List<String> rooms = new ArrayList<>();
  private final SimRandom random;
  private long nowNs = 1_000_000_000L;
  private double stayS;
  private double comes;
  private double goes;
  private int all;
  private int wanted;
  private long joins;
  private long moves;
  private long refused;
  private int mostOwners;
  private long turns;
  private long turnNs;

  /**
   * Starts servers with rooms, in which nobody plays yet.
   *
   * @param servers how many
   * @param rooms of all servers together
   * @param places of each room
   */
  public ToyFleet(int servers, int rooms, int places, long seed) throws IOException {
    random = new SimRandom(seed);
    for (int i = 0; i < servers; i++) {
      Node node = new Node("s" + i);
      nodes.put(node.name, node);
      List<RoomConfig> own = new ArrayList<>();
      for (int r = i; r < rooms; r += servers) {
        String name = "r" + r;
        this.rooms.add(name);
        players.put(name, 0);
        own.add(new RoomConfig(name, GAME, List.of(), places, r, Map.of()));
      }
      node.begin(own);
    }
  }

  private long now() {
    return nowNs;
  }

  /**
   * Lets players come and go from now on.
   *
   * @param count how many play on average
   * @param newStayS for how long each stays on average, s
   */
  public void populate(int count, double newStayS) {
    wanted = count;
    stayS = newStayS;
    for (; all < count; all++) {
      players.merge(rooms.get(all % rooms.size()), 1, Integer::sum);
    }
  }

  /** Lets time pass, s. */
  public void run(double seconds) {
    for (long endNs = nowNs + (long) (seconds * NS_PER_S); nowNs < endNs; nowNs += STEP_NS) {
      directory.tick();
      comeAndGo();
      nodes.values().forEach(node -> node.rung = true);
      for (int round = 0; round < MOST_ROUNDS; round++) {
        nodes.values().forEach(Node::turn);
      }
      mostOwners = Math.max(mostOwners, countOwners());
    }
  }

  private void comeAndGo() {
    double each = stayS == 0 ? 0 : STEP_NS / NS_PER_S / stayS;
    goes += all * each;
    for (; goes >= 1 && all > 0; goes--) {
      String room;
      do {
        room = rooms.get(random.nextInt(rooms.size()));
      } while (players.get(room) == 0);
      players.merge(room, -1, Integer::sum);
      all--;
    }
    comes += wanted * each;
    for (; comes >= 1; comes--) {
      join();
    }
  }

  /** Lets a player come to any server. */
  private void join() {
    List<Node> alive = nodes.values().stream().filter(node -> !node.dead).toList();
    Node door = alive.get(random.nextInt(alive.size()));
    joins++;
    for (int tries = 0; tries < MOST_TRIES && door != null; tries++) {
      FleetDoor.Place there = door.member.door().best(ANY, Link.Door.OWN);
      ToyRoom here = door.host.best();
      boolean goes =
          there != null && (here == null || ANY.fit(there.offer()) > ANY.fit(here.offer()));
      String room = goes ? there.room() : here == null ? null : here.name();
      door = goes ? sent(door, there) : door;
      if (room != null && door != null && door.host.takes(room)) {
        players.merge(room, 1, Integer::sum);
        all++;
        return;
      } // else the room has filled up while the player came here
    }
    refused++;
  }

  /** Sends a player to another server with a ticket; returns that server, or null. */
  private Node sent(Node from, FleetDoor.Place there) {
    moves++;
    FleetDoor.Guest guest =
        new FleetDoor.Guest("Ann", "", there.room(), "", "", PlayerSkill.NO_CLAIM, true);
    ServerMessage answer = FleetDoor.outcome(from.member.door().move(there, guest, Link.Door.OWN));
    if (!(answer instanceof ServerMessage.Move move)) {
      return null;
    }
    Node to = nodes.get(move.server().substring(0, move.server().indexOf(':')));
    return to.dead || FleetDoor.outcome(to.member.door().redeem(move.ticket())) == null ? null : to;
  }

  /** Returns the largest number of servers of which each may let the same room tick. */
  private int countOwners() {
    Map<String, Integer> owners = new HashMap<>();
    int most = 0;
    for (Node node : nodes.values()) {
      for (ToyRoom room : node.dead ? List.<ToyRoom>of() : node.host.rooms) {
        if (room.ownership.holds() && !room.closed) {
          most = Math.max(most, owners.merge(room.name(), 1, Integer::sum));
        }
      }
    }
    return most;
  }

  /** Returns how many rooms have an owner. */
  public int owned() {
    int owned = 0;
    for (Node node : nodes.values()) {
      for (ToyRoom room : node.dead ? List.<ToyRoom>of() : node.host.rooms) {
        owned += room.ownership.holds() && !room.closed ? 1 : 0;
      }
    }
    return owned;
  }

  /** Returns how many rooms a server owns. */
  public int rooms(int server) {
    return nodes.get("s" + server).host.rooms.size();
  }

  /** Returns how many rooms another server could go on with. */
  public int followed() {
    int followed = 0;
    for (Node node : nodes.values()) {
      for (ToyRoom room : node.dead ? List.<ToyRoom>of() : node.host.rooms) {
        followed += room.followed ? 1 : 0;
      }
    }
    return followed;
  }

  /** Ends the process of a server at once. */
  public void kill(int server) {
    Node killed = nodes.get("s" + server);
    killed.dead = true;
    long lease = killed.member.number();
    for (Node other : nodes.values()) {
      if (!other.dead) {
        other.member.inbox().lost(lease);
        other.member.inbox().dead(lease);
      }
    }
  }

  /** Lets a server give all its rooms away. */
  public void drain(int server) {
    nodes.get("s" + server).member.drain();
  }

  /** Returns what the servers have asked the directory and heard from it so far. */
  public DirectoryTraffic traffic() {
    DirectoryTraffic sum = new DirectoryTraffic();
    nodes.values().forEach(node -> sum.add(node.directory.traffic));
    return sum;
  }

  /** Returns the turns that all servers have done so far. */
  public long turns() {
    return turns;
  }

  /** Returns the true time that these turns have taken, s. */
  public double turnS() {
    return turnNs / NS_PER_S;
  }

  /** Returns how many players there are. */
  public int players() {
    return all;
  }

  /** Returns how many players have come, in rooms or not. */
  public long joins() {
    return joins;
  }

  /** Returns how many of them were sent to another server. */
  public long moves() {
    return moves;
  }

  /** Returns how many got no place. */
  public long refused() {
    return refused;
  }

  /** Returns the largest number of owners that a room has had at a time. */
  public int mostOwners() {
    return mostOwners;
  }

  @Override
  public void close() {
    nodes.values().forEach(node -> node.member.close());
  }

  private final class Node {
    final String name;
    final MeteredDirectory directory = new MeteredDirectory(ToyFleet.this.directory.door());
    final ToyHost host = new ToyHost();
    final FleetMember member;
    boolean dead;
    private boolean rung;

    Node(String name) throws IOException {
      this.name = name;
      FleetSettings settings =
          new FleetSettings(
              name,
              name + ":1",
              "",
              "",
              "fleet",
              false,
              false,
              0,
              64,
              Durability.ASYNC,
              Path.of("unused"));
      member =
          new FleetMember(
              directory,
              settings,
              ToyFleet.this::now,
              Runnable::run,
              Runnable::run,
              () -> rung = true);
      member.reachesBy(new ToyPeers(this), name + ":2");
      member.join();
    }

    /** Does a turn, if it is time or something has changed. */
    void turn() {
      if (rung && !dead) {
        rung = false;
        turns++;
        long beginNs = System.nanoTime();
        member.turn(nowNs);
        turnNs += System.nanoTime() - beginNs;
      }
    }

    void begin(List<RoomConfig> own) throws IOException {
      for (RoomConfig room : member.claim(own, false, () -> {})) {
        host.add(new ToyRoom(room, member.ownershipOf(room)));
      }
      member.serves(host);
    }
  }

  private final class ToyRoom implements FleetRoom {
    private final RoomConfig settings;
    private final Ownership ownership;
    private boolean followed;
    private boolean closed;

    ToyRoom(RoomConfig settings, Ownership ownership) {
      this.settings = settings;
      this.ownership = ownership;
    }

    @Override
    public String name() {
      return settings.name();
    }

    @Override
    public RoomConfig settings() {
      return settings;
    }

    @Override
    public ServerMessage.RoomEntry entry() {
      return new ServerMessage.RoomEntry(
          name(), GAME, "Field", "playing", players(), settings.places(), 0, Map.of());
    }

    @Override
    public RoomOffer offer() {
      return new RoomOffer(GAME, players(), settings.places(), null);
    }

    @Override
    public int players() {
      return players.get(name());
    }

    @Override
    public Set<String> parties() {
      return Set.of();
    }

    @Override
    public Set<String> accounts() {
      return Set.of();
    }

    @Override
    public int loadPercent() {
      return players();
    }

    @Override
    public int tick() {
      return 1;
    }

    @Override
    public int tickRateHz() {
      return 60;
    }

    @Override
    public boolean hasFailed() {
      return false;
    }

    @Override
    public boolean isClosed() {
      return closed;
    }

    @Override
    public Ownership ownership() {
      return ownership;
    }

    @Override
    public void ownershipChanged() {}

    @Override
    public boolean isFollowed() {
      return followed;
    }

    @Override
    public int followerLag() {
      return 0;
    }

    @Override
    public int lostTicks() {
      return 0;
    }

    @Override
    public void followedBy(SlotDisk disk, SlotLink link, int seconds, boolean waits) {
      followed = link != null;
    }

    @Override
    public Set<Long> linked() {
      return Set.of(); // toy players have no clients
    }

    @Override
    public void closeClients() {}

    @Override
    public void sendOn(ServerMessage.Move move, Set<Long> standbys) {}

    @Override
    public void handOver(Function<Link.Door, ServerMessage.Redirect> where, Runnable ended) {
      closed = true;
      ended.run();
    }
  }

  private final class ToyHost implements RoomHost {
    private final List<ToyRoom> rooms = new ArrayList<>();
    private final Map<String, ToyRoom> byName = new HashMap<>();

    void add(ToyRoom room) {
      rooms.add(room);
      byName.put(room.name(), room);
    }

    ToyRoom best() {
      ToyRoom best = null;
      int most = -1;
      for (ToyRoom room : rooms) {
        int fit = room.closed ? -1 : ANY.fit(room.offer());
        if (fit > most) {
          most = fit;
          best = room;
        }
      }
      return best;
    }

    boolean takes(String name) {
      ToyRoom room = byName.get(name);
      return room != null && room.players() < room.settings.places();
    }

    @Override
    public List<ToyRoom> rooms() {
      return List.copyOf(rooms);
    }

    @Override
    public ToyRoom room(String name) {
      return byName.get(name);
    }

    @Override
    public boolean hasThreads() {
      return false;
    }

    @Override
    public FleetRoom prepare(RoomConfig settings, Path slots, Ownership ownership) {
      return new ToyRoom(settings, ownership);
    }

    @Override
    public void takeOver(FleetRoom room, Path slots) {
      add((ToyRoom) room);
    }

    @Override
    public void drop(FleetRoom room, String why) {
      forget(room);
    }

    @Override
    public void forget(FleetRoom room) {
      rooms.remove((ToyRoom) room);
      byName.remove(room.name(), room);
    }
  }

  /** Links that carry what hands rooms over, and lose nothing. */
  private final class ToyPeers implements Peers {
    private final Node self;
    private final Set<Long> reached = new TreeSet<>();

    ToyPeers(Node self) {
      this.self = self;
    }

    private Node node(long server) throws IOException {
      for (Node node : nodes.values()) {
        if (!node.dead && node.member.number() == server) {
          return node;
        }
      }
      throw new IOException("server " + server + " is gone");
    }

    @Override
    public void reach(ServerRecord server) {
      reached.add(server.lease());
    }

    @Override
    public void forget(long server) {
      reached.remove(server);
    }

    @Override
    public Set<Long> reached() {
      return Set.copyOf(reached);
    }

    @Override
    public boolean isReached(long server) {
      return reached.contains(server);
    }

    @Override
    public void send(long server, PeerFrame frame) throws IOException {
      Node to = node(server);
      if (frame.kind() == PeerFrame.Kind.HAND_OVER) {
        to.member.inbox().take(self.member.number(), frame);
      }
    }

    @Override
    public void whenDone(long server, Runnable then) {
      then.run();
    }

    @Override
    public void await(long server) throws IOException {
      node(server);
    }

    @Override
    public PeerFrame ask(ServerRecord server, PeerFrame question) throws IOException {
      return node(server.lease()).member.inbox().answer(question);
    }

    @Override
    public void close() {
      reached.clear();
    }
  }
}
