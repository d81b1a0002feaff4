package carom.server;

import carom.net.kryo.KryoMessageCodec;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.transport.InProcessNetwork;
import carom.server.account.AccountService;
import carom.server.account.AccountStore;
import carom.server.checkpoint.SlotDisk;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.HandedInMatch;
import carom.server.match.MatchLibrary;
import carom.server.room.Room;
import carom.server.session.Session;
import carom.sim.Game;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** A server of {@link EarnGame} in virtual time, whose disk and store work when the test wants. */
final class AccountRig implements AutoCloseable {
  final InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
  final Server server;
  final AccountService accounts;
  final List<FakeClient> clients = new ArrayList<>();

  /** Steps of writing that the disk hasn't done. */
  final ArrayDeque<Runnable> disk = new ArrayDeque<>();

  long nowNs;

  /** The game that is played if it isn't installed, or null. */
  Game game;

  /**
   * Starts a server.
   *
   * @param folder of checkpoints; null for none
   * @param scratch gets the backend's key
   */
  AccountRig(AccountStore store, Path folder, Path scratch, long nowNs, String... rooms)
      throws Exception {
    this(
        store,
        folder,
        scratch,
        nowNs,
        ServerConfig.defaults(),
        "earn",
        new HandedInMatch(EarnGame::new, EarnGame.level()),
        rooms);
    game = new EarnGame();
  }

  /** Starts a server of another game, which plays a level of a library. */
  AccountRig(
      AccountStore store,
      Path folder,
      Path scratch,
      long nowNs,
      ServerConfig config,
      String level,
      MatchLibrary library,
      String... rooms)
      throws Exception {
    this.nowNs = nowNs;
    List<RoomConfig> configs = new ArrayList<>();
    for (String room : rooms) {
      configs.add(new RoomConfig(room, "", List.of(level), 8, 7, Map.of()));
    }
    server =
        new Server(
            config.with(ServerConfig.STATUS_INTERVAL, 0).with(ServerConfig.GRACE, 600),
            configs,
            library,
            network.server(),
            () -> this.nowNs);
    accounts = new AccountService(store, () -> this.nowNs);
    server.accounts(accounts);
    server.admit(Backend.rule(scratch));
    if (folder != null) {
      SlotDisk slots = new SlotDisk(disk::add);
      for (Room room : server.rooms()) {
        room.checkpoint(slots, folder.resolve(room.name()), 1);
      }
      server.rooms().forEach(room -> room.reconcile(server.rooms()));
    }
    server.tick(nowNs);
  }

  static String token(String account) throws Exception {
    return Backend.token(account);
  }

  /** Sends a greeting in the name of an account. */
  FakeClient hello(String account, String room, long secret) throws Exception {
    FakeClient client = new FakeClient(network.client().connect("", 0, 0));
    client.game = game;
    client.link.send(
        new ClientMessage.Hello(
            Protocol.VERSION,
            Protocol.physicsDigest(),
            "P" + account,
            secret,
            room,
            "",
            "",
            token(account)));
    clients.add(client);
    return client;
  }

  /** Joins and plays. */
  FakeClient join(String account, String room) throws Exception {
    FakeClient client = hello(account, room, 0);
    for (int i = 0; i < 300 && session(account, room) == null; i++) {
      step();
      work();
    }
    return client;
  }

  /** Does a tick, and nothing of what waits for the disk or the store. */
  void step() {
    nowNs += KeptServer.TICK_NS;
    for (FakeClient client : clients) {
      client.step(client.welcome == null ? 0 : room(client.welcome.room()).tick());
    }
    server.tick(nowNs);
  }

  /** Does what waits for the disk and the store. */
  void work() {
    while (!disk.isEmpty()) {
      disk.poll().run();
    }
    while (accounts.turn()) {}
  }

  /** Plays on until everything is stored. */
  void settle() {
    for (int i = 0; i < 240; i++) {
      step();
      work();
    }
  }

  Room room(String name) {
    return server.rooms().stream().filter(r -> r.name().equals(name)).findAny().orElseThrow();
  }

  /** Returns the session of an account, or null. */
  Session session(String account, String name) {
    Room room = room(name);
    for (int id = 0; id < room.seats().count(); id++) {
      Session session = room.session(id);
      if (session != null && session.seat().account().equals(account)) {
        return session;
      }
    }
    return null;
  }

  int coins(String account, String room) {
    return session(account, room).player().get(EarnGame.COINS);
  }

  /** Returns what a room has paid to an account. */
  int paid(String account, String room) {
    return room(room).simulation().get(EarnGame.PAID, Integer.parseInt(account));
  }

  @Override
  public void close() {
    server.close();
    work();
  }
}
