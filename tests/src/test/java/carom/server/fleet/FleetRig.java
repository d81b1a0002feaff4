package carom.server.fleet;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.PredictionMode;
import carom.client.bots.Bot;
import carom.net.kryo.KryoMessageCodec;
import carom.net.transport.ClientTransport;
import carom.net.transport.InProcessNetwork;
import carom.net.transport.Link;
import carom.server.Server;
import carom.server.config.DataFolder;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.config.ServerConfig.Durability;
import carom.server.directory.MemoryDirectory;
import carom.server.match.MatchLibrary;
import carom.server.room.FleetRoom;
import carom.server.room.Room;
import carom.server.session.Ownership;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * A fleet in virtual time: servers with a directory in memory, and clients that reach each server
 * by its name. One thread does everything.
 */
public final class FleetRig implements AutoCloseable {
  static final long SLICE_NS = 5_000_000;

  /** One client of so many predicts: that costs most, and where a room is changes nothing in it. */
  private static final int PREDICTING = 6;

  public final Map<String, Node> nodes = new LinkedHashMap<>();
  final List<GameClient> clients = new ArrayList<>();
  final MemoryDirectory directory = new MemoryDirectory(this::now);

  /** How the servers' rooms are kept; before the first one. */
  Durability durability = Durability.ASYNC;

  /** By which newcomers get a room; before the first one. */
  ServerConfig.RoomRule roomRule = ServerConfig.RoomRule.FILL;

  /** What the next server's rooms play. */
  String level = "arena";

  /** Time that each word takes from one server to another. */
  long lagNs;

  /** Pace of the clock of the next server. */
  double nextPace = 1;

  /** Time that a server needs to take a room over, s. */
  double takeoverS;

  /** Servers to which clients' new links don't get. */
  final Set<String> unreachable = new TreeSet<>();

  /** What is under way between two servers, by both names, in order. */
  private final Map<String, ArrayDeque<Parcel>> wires = new TreeMap<>();

  private final Path folder;
  private final int places;
  private long nowNs = 1_000_000_000L;

  /**
   * Creates a fleet without servers.
   *
   * @param places of each room
   */
  public FleetRig(Path folder, int places) {
    this.folder = folder;
    this.places = places;
  }

  /** Returns what draws a fleet's fate, and prints the seed. */
  static Random draws() {
    long seed = Long.getLong("carom.fleet.seed", System.nanoTime());
    System.out.println("fleet of seed " + seed + " (-Dcarom.fleet.seed=" + seed + ")");
    return new Random(seed);
  }

  long now() {
    return nowNs;
  }

  /** Something under way to a server: a frame, or what runs when its answer comes back. */
  private record Parcel(long atNs, Node from, Node to, long lease, PeerFrame frame, Runnable then) {

    void arrive() throws IOException {
      if (frame == null) {
        then.run();
      } else {
        to.member.inbox().take(lease, PeerFrame.parse(frame.toBytes()));
      }
    }
  }

  private void deliver(boolean all, ArrayDeque<Parcel> wire) throws IOException {
    while (!wire.isEmpty()) {
      Parcel first = wire.peekFirst();
      if (!all && (first.atNs > nowNs || first.to.frozen || first.to.stuck)) {
        return;
      }
      wire.removeFirst();
      if (!first.to.dead && !first.from.dead) {
        first.arrive();
      }
    }
  }

  private void deliver() {
    try {
      for (ArrayDeque<Parcel> wire : List.copyOf(wires.values())) {
        deliver(false, wire);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** A server of the fleet. */
  public final class Node {
    final String name;
    final InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec(), "fleet");
    final MemoryDirectory.Door door = directory.door();
    public final FleetMember member;
    final MemoryPeers peers = new MemoryPeers(this);
    public final Server server;
    boolean dead;
    boolean frozen;

    /** Seconds of its clock in one true second. */
    final double pace = nextPace;

    /** Whether it hears nothing of other servers, though it lives. */
    boolean stuck;

    /** Whether the word is lost by which it hands a room over. */
    boolean mumbles;

    Node(String name, int rooms) throws IOException {
      this.name = name;
      FleetSettings settings =
          new FleetSettings(
              name,
              name,
              name + ":2",
              "",
              "fleet",
              true,
              false,
              0,
              2,
              durability,
              folder.resolve(name).resolve("followed"));
      member = new FleetMember(door, settings, this::now, Runnable::run, Runnable::run, () -> {});
      member.reachesBy(peers, name + ":1");
      member.keepsSaves(new DataFolder(folder.resolve(name)));
      member.join();
      ServerConfig config =
          ServerConfig.defaults()
              .with(ServerConfig.STATUS_INTERVAL, 0)
              .with(ServerConfig.IDLE, ServerConfig.Idle.PAUSE)
              .with(ServerConfig.ROOMS, Math.max(1, rooms))
              .with(ServerConfig.ROOM_RULE, roomRule)
              .with(ServerConfig.MAX_PLAYERS, places);
      List<RoomConfig> own =
          rooms == 0
              ? List.of()
              : member.claim(RoomConfig.equalRooms(config, List.of(level)), true, () -> {});
      server =
          new Server(
              config,
              own,
              MatchLibrary.INSTALLED,
              network.server(),
              this::now,
              member::ownershipOf);
      server.fleet(member.door());
      member.serves(new SlowHost(server));
    }

    /** Returns a room of the server, or null. */
    Room room(String name) {
      return (Room) server.room(name);
    }

    /** Ends the process at once. */
    public void kill() {
      dead = true;
      network.server().close();
      long lease = member.number();
      for (Node other : nodes.values()) {
        if (other != this && !other.dead) {
          other.member.inbox().lost(lease);
          other.member.inbox().dead(lease);
        }
      }
    }

    /** Moves its rooms away and ends, as SIGTERM does. */
    void leave() {
      member.drain();
      for (int i = 0; i < 100 && !member.isDrained(); i++) {
        run(0.05);
      }
      dead = true;
      network.server().close();
      member.close();
    }

    void turn() {
      if (!dead && !frozen) {
        member.turn(now());
        server.tick(now());
      }
    }

    private long now() {
      return (long) (nowNs * pace);
    }

    /** Lets the others believe that it is dead, as a firewall or a proxy may. */
    void slander() {
      for (Node other : nodes.values()) {
        if (other != this && !other.dead) {
          other.member.inbox().dead(member.number());
        }
      }
    }
  }

  /** A server that takes its time to take a room over, while all else goes on. */
  private final class SlowHost implements RoomHost {
    private final RoomHost host;

    SlowHost(RoomHost host) {
      this.host = host;
    }

    @Override
    public FleetRoom prepare(RoomConfig own, Path slots, Ownership ownership) {
      return host.prepare(own, slots, ownership);
    }

    @Override
    public void takeOver(FleetRoom room, Path slots) {
      run(takeoverS);
      host.takeOver(room, slots);
    }

    @Override
    public List<? extends FleetRoom> rooms() {
      return host.rooms();
    }

    @Override
    public FleetRoom room(String name) {
      return host.room(name);
    }

    @Override
    public void forget(FleetRoom room) {
      host.forget(room);
    }

    @Override
    public void drop(FleetRoom room, String why) {
      host.drop(room, why);
    }

    @Override
    public boolean hasThreads() {
      return host.hasThreads();
    }
  }

  /** Links between the servers of the rig, which lose nothing. */
  private final class MemoryPeers implements Peers {
    private final Node self;
    private final Set<Long> reached = new TreeSet<>();

    MemoryPeers(Node self) {
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
      try {
        return reached.contains(server) && node(server) != null;
      } catch (IOException e) {
        return false;
      }
    }

    @Override
    public void send(long server, PeerFrame frame) throws IOException {
      if (self.mumbles && frame.kind() == PeerFrame.Kind.HAND_OVER) {
        throw new IOException("the link is lost");
      }
      put(node(server), frame, null, lagNs);
    }

    private ArrayDeque<Parcel> wire(Node to) {
      return wires.computeIfAbsent(self.name + ">" + to.name, name -> new ArrayDeque<>());
    }

    private void put(Node to, PeerFrame frame, Runnable then, long lag) throws IOException {
      ArrayDeque<Parcel> wire = wire(to);
      wire.add(new Parcel(nowNs + lag, self, to, self.member.number(), frame, then));
      if (lag == 0) {
        deliver(false, wire);
      }
    }

    @Override
    public void whenDone(long server, Runnable then) throws IOException {
      put(node(server), null, then, 2 * lagNs); // there and back
    }

    @Override
    public void await(long server) throws IOException {
      if (node(server).stuck) {
        throw new IOException("server " + node(server).name + " doesn't answer");
      }
      deliver(true, wire(node(server)));
    }

    @Override
    public PeerFrame ask(ServerRecord server, PeerFrame question) throws IOException {
      return node(server.lease()).member.inbox().answer(PeerFrame.parse(question.toBytes()));
    }

    @Override
    public void close() {
      reached.clear();
    }
  }

  /** Adds a server with some rooms of its own. */
  public Node node(String name, int rooms) throws IOException {
    Node node = new Node(name, rooms);
    nodes.put(name, node);
    return node;
  }

  /** Reaches the servers by their names. */
  private final class Roads implements ClientTransport {
    @Override
    public Link connect(String host, int tcpPort, int udpPort) {
      Link link = nodes.get(host).network.client().connect(host, 0, 0);
      if (unreachable.contains(host)) {
        link.close("unreachable");
      }
      return link;
    }

    @Override
    public void close() {}
  }

  /** Adds a client that joins at a server. */
  public GameClient client(String name, String server) {
    return client(name, server, "");
  }

  /** Adds a client of a party that joins at a server. */
  GameClient client(String name, String server, String party) {
    return client(ClientConfig.of(name).with(ClientConfig.PARTY, party), server);
  }

  /** Adds a client that joins at a server. */
  GameClient client(ClientConfig own, String server) {
    ClientConfig config = own.withServer(server, 1, 1);
    if (clients.size() % PREDICTING != 0) {
      config = config.with(ClientConfig.PREDICTION, PredictionMode.NONE);
    }
    GameClient client = new GameClient(config, new Roads(), new Bot(clients.size()), () -> 0);
    clients.add(client);
    return client;
  }

  /** Lets time pass, s. */
  public void run(double seconds) {
    for (long endNs = nowNs + (long) (seconds * 1e9); nowNs < endNs; nowNs += SLICE_NS) {
      directory.tick();
      deliver();
      nodes.values().forEach(Node::turn);
      clients.forEach(client -> client.update(nowNs));
    }
  }

  /** Returns the names of the rooms that the servers have. */
  Set<String> rooms() {
    Set<String> rooms = new TreeSet<>();
    nodes.values().forEach(node -> node.server.rooms().forEach(room -> rooms.add(room.name())));
    return rooms;
  }

  /** Returns the servers whose room of a name may tick now. */
  List<Node> owners(String room) {
    List<Node> owners = new ArrayList<>();
    for (Node node : nodes.values()) {
      Room one = node.dead ? null : node.room(room);
      if (one != null && one.ownership().holds() && !one.isClosed()) {
        owners.add(node);
      }
    }
    return owners;
  }

  @Override
  public void close() {
    for (Node node : nodes.values()) {
      node.server.close();
      node.member.close();
    }
  }
}
