package carom.server.fleet;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.bots.Bot;
import carom.net.kryo.KryoMessageCodec;
import carom.net.transport.ClientTransport;
import carom.net.transport.InProcessNetwork;
import carom.net.transport.Link;
import carom.server.Server;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.directory.MemoryDirectory;
import carom.server.match.MatchLibrary;
import carom.server.room.Room;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/**
 * A fleet in virtual time: servers with a directory in memory, and clients that reach each server
 * by its name. One thread does everything.
 */
final class FleetRig implements AutoCloseable {
  static final long SLICE_NS = 5_000_000;

  final Map<String, Node> nodes = new LinkedHashMap<>();
  final List<GameClient> clients = new ArrayList<>();
  final MemoryDirectory directory = new MemoryDirectory(this::now);
  private final Path folder;
  private final int places;
  private long nowNs = 1_000_000_000L;

  FleetRig(Path folder, int places) {
    this.folder = folder;
    this.places = places;
  }

  long now() {
    return nowNs;
  }

  /** A server of the fleet. */
  final class Node {
    final String name;
    final InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec(), "fleet");
    final MemoryDirectory.Door door = directory.door();
    final FleetMember member;
    final MemoryPeers peers = new MemoryPeers(this);
    final Server server;
    boolean dead;
    boolean frozen;

    /** Whether the word is lost by which it hands a room over. */
    boolean mumbles;

    Node(String name, int rooms) throws IOException {
      this.name = name;
      FleetSettings settings =
          new FleetSettings(
              name, name, "fleet", false, 0, folder.resolve(name).resolve("followed"));
      member = new FleetMember(door, settings, FleetRig.this::now, Runnable::run, () -> {});
      member.reachesBy(peers, name + ":1");
      member.join();
      ServerConfig config =
          ServerConfig.defaults()
              .with(ServerConfig.STATUS_INTERVAL, 0)
              .with(ServerConfig.ROOMS, Math.max(1, rooms))
              .with(ServerConfig.MAX_PLAYERS, places);
      List<RoomConfig> own =
          rooms == 0
              ? List.of()
              : member.claim(RoomConfig.equalRooms(config, List.of("arena")), true);
      server =
          new Server(
              config,
              own,
              MatchLibrary.INSTALLED,
              network.server(),
              FleetRig.this::now,
              member::ownershipOf);
      server.fleet(member);
      member.serves(server);
    }

    /** Ends the process at once. */
    void kill() {
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

    void turn() {
      if (!dead && !frozen) {
        member.turn(nowNs);
        server.tick(nowNs);
      }
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
      node(server).member.inbox().take(self.member.number(), PeerFrame.parse(frame.toBytes()));
    }

    @Override
    public void await(long server) throws IOException {
      node(server);
    }

    @Override
    public void close() {
      reached.clear();
    }
  }

  Node node(String name, int rooms) throws IOException {
    Node node = new Node(name, rooms);
    nodes.put(name, node);
    return node;
  }

  /** Reaches the servers by their names. */
  private final class Roads implements ClientTransport {
    @Override
    public Link connect(String host, int tcpPort, int udpPort) {
      return nodes.get(host).network.client().connect(host, 0, 0);
    }

    @Override
    public void close() {}
  }

  GameClient client(String name, String server) {
    ClientConfig config =
        ClientConfig.of(name).withServer(server, 1, 1).with(ClientConfig.RECONNECT, true);
    GameClient client = new GameClient(config, new Roads(), new Bot(clients.size()), () -> 0);
    clients.add(client);
    return client;
  }

  void run(double seconds) {
    for (long endNs = nowNs + (long) (seconds * 1e9); nowNs < endNs; nowNs += SLICE_NS) {
      directory.tick();
      nodes.values().forEach(Node::turn);
      clients.forEach(client -> client.update(nowNs));
    }
  }

  /** Returns the servers whose room of a name may tick now. */
  List<Node> owners(String room) {
    List<Node> owners = new ArrayList<>();
    for (Node node : nodes.values()) {
      Room one = node.dead ? null : node.server.room(room);
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
