package carom.server;

import carom.game.GameFault;
import carom.net.kryo.KryoMessageCodec;
import carom.net.kryo.server.KryoLimits;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.kryo.server.ProxyRule;
import carom.net.kryo.server.ServerIdentity;
import carom.net.seal.Encryption;
import carom.net.seal.ServerKey;
import carom.net.transport.ImpairedServerTransport;
import carom.net.transport.Impairment;
import carom.net.transport.PortUnavailableException;
import carom.net.transport.ServerTransport;
import carom.net.transport.ServerTransports;
import carom.options.BadFlag;
import carom.options.Setting;
import carom.server.access.AccessLists;
import carom.server.access.AddressRange;
import carom.server.access.GamePassword;
import carom.server.access.LoginThrottle;
import carom.server.access.Secret;
import carom.server.account.AccountService;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.fleet.FleetFlags;
import carom.server.fleet.FleetService;
import carom.server.lobby.Lobby;
import carom.server.match.MatchLibrary;
import carom.server.metrics.Counter;
import carom.server.recording.RotationLimit;
import carom.server.room.BotCrew;
import carom.server.session.Ownership;
import carom.server.session.SessionMemory;
import carom.server.thin.plain.PlainDoor;
import carom.server.thin.plain.PlainFlags;
import carom.server.thin.web.PlayFlags;
import carom.server.thin.web.PlayPort;
import carom.server.upload.Uploads;
import carom.text.FileErrors;
import com.sun.management.UnixOperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.Inet6Address;
import java.net.InetAddress;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicInteger;
import org.slf4j.Logger;

/**
 * Builds the server of {@code carom-server} from its flags: opens the ports, then sets up the
 * rooms, the recording and the spectators. A step that fails closes what the steps before it
 * opened.
 */
final class ServerStart {
  /** Open files besides those of players: jars, logs, ports, and links that wait. */
  private static final int SPARE_FILES = 500;

  /** Longest time in which Agones must tell the address of the pod, ms. */
  private static final int ADDRESS_MS = 30_000;

  private final ServerFlags flags;
  private final GameChoice choice;
  private ServerConfig config;
  private final AccessLists access;
  private final AgonesService agones; // or null
  private GameServer pod; // or null if nothing is asked of it
  private final Logger log;
  private final AtomicInteger steps = new AtomicInteger();
  private volatile Server server;
  private PlayPort play; // or null
  private PlainDoor plain; // or null
  private FleetService fleet; // or null

  ServerStart(
      ServerFlags flags,
      GameChoice choice,
      ServerConfig config,
      AccessLists access,
      AgonesService agones,
      Logger log) {
    this.flags = flags;
    this.choice = choice;
    this.config = config;
    this.access = access;
    this.agones = agones;
    this.log = log;
  }

  /**
   * Plays the game for a moment without a network; see {@link GameWarmup}.
   *
   * @throws BadFlag when the game can't be played in the level
   */
  void warmUp() {
    try {
      Path followed =
          FleetFlags.isFleet(config) ? flags.dataFolder().followed().resolve(".warm-up") : null;
      GameWarmup.play(
          config,
          choice::newGame,
          choice.warmUpLevel(),
          new KryoMessageCodec(),
          followed,
          steps::incrementAndGet);
    } catch (IllegalArgumentException e) {
      throw flags.bad(GameFault.refusal(choice.newGame().getClass(), e));
    }
  }

  /**
   * Opens the ports and the recordings and returns a server that the caller can start.
   *
   * @throws BadFlag when a flag can't be used
   * @throws StartFailure when a port or a file is not available
   */
  Server open() throws StartFailure {
    List<RoomConfig> rooms = choice.rooms(config);
    awaitPod();
    ServerTransport transport = openTransport(rooms);
    if (FleetFlags.isFleet(config)) {
      rooms = joinFleet(rooms, transport);
    }
    server = openRooms(rooms, transport);
    if (fleet != null) {
      server.fleet(fleet.member().door());
    }
    compareWithOpenFiles(RoomConfig.places(rooms));
    SessionMemory.touch(RoomConfig.places(rooms));
    try {
      server.bots(bots());
      demandPassword();
      remember();
      keep();
      record();
      show();
      return server;
    } catch (BadFlag | StartFailure e) {
      server.close();
      throw e;
    }
  }

  /** Waits until Agones tells address and ports of the pod, if the settings leave them to it. */
  private void awaitPod() throws StartFailure {
    boolean named =
        config.get(ServerConfig.TCP_PORT) > 0
            && config.get(ServerConfig.UDP_PORT) > 0
            && (!FleetFlags.isFleet(config) || config.get(ServerConfig.ADVERTISE) != null);
    if (agones == null || named) {
      return;
    }
    try {
      pod = agones.awaitAddress(ADDRESS_MS);
    } catch (IOException e) {
      throw new StartFailure("--agones: " + e.getMessage(), e);
    }
  }

  /** Returns a port that an operator has set; if that is 0, the pod's of a name if it has one. */
  private int podPort(Setting<Integer> row, String name) {
    int port = config.get(row);
    return port == 0 && pod != null ? pod.port(name) : port;
  }

  /** Tells if not all places can be taken at once, since each player's link is an open file. */
  private void compareWithOpenFiles(int places) {
    if (ManagementFactory.getOperatingSystemMXBean() instanceof UnixOperatingSystemMXBean system
        && system.getMaxFileDescriptorCount() < places + SPARE_FILES) {
      log.warn(
          "places={} in all rooms need as many open files, this process may open {}: raise that"
              + " (ulimit -n, LimitNOFILE), or lower --max-players or --rooms",
          places,
          system.getMaxFileDescriptorCount());
    }
  }

  /** Joins the fleet and returns the rooms that this server owns there. */
  private List<RoomConfig> joinFleet(List<RoomConfig> rooms, ServerTransport transport)
      throws StartFailure {
    List<InetAddress> bind = flags.bindAddresses();
    boolean numbered = flags.get(ServerConfig.ROOM).isEmpty();
    try {
      ServerConfig advertised = config;
      String peer = null;
      if (config.get(ServerConfig.ADVERTISE) == null) {
        advertised = config.with(ServerConfig.ADVERTISE, pod.advertise());
        peer = pod.peer();
      }
      String host = FleetFlags.host(advertised.get(ServerConfig.ADVERTISE));
      int port = podPort(ServerConfig.FLEET_PORT, GameServer.FLEET);
      advertised = advertised.with(ServerConfig.FLEET_PORT, port);
      fleet =
          FleetService.join(
              advertised,
              ServerKey.load(flags.get(ServerConfig.FLEET_KEY)),
              bind.isEmpty() ? null : bind.get(0),
              transport.tcpPort(),
              PlayFlags.address(config, host, play),
              PlainFlags.address(host, plain),
              peer,
              flags.dataFolder(),
              access.shared());
      return fleet.claim(rooms, numbered, steps::incrementAndGet);
    } catch (IOException e) {
      transport.close();
      if (fleet != null) {
        fleet.close();
      }
      throw new StartFailure("--fleet: " + e.getMessage(), e);
    } catch (IllegalArgumentException e) {
      transport.close();
      throw flags.bad("--fleet: " + e.getMessage());
    }
  }

  /** Returns the server's part in its fleet, or null if it has none. */
  FleetService fleet() {
    return fleet;
  }

  private ServerTransport openTransport(List<RoomConfig> rooms) throws StartFailure {
    List<ServerTransport> all = new ArrayList<>();
    all.add(openOwnPorts(rooms));
    int places = RoomConfig.places(rooms);
    try {
      plain = PlainFlags.open(config, flags.bindAddresses());
      Impairment impairment = flags.impairment();
      if (plain != null) {
        all.add(plain);
        if (impairment != null) {
          plain.simulate(impairment);
        }
      }
      play =
          PlayFlags.open(
              config,
              flags.bindAddresses(),
              Lobby.mostLinks(places),
              Lobby.mostLinksOfAddress(places));
      if (play != null) {
        config = config.with(ServerConfig.PLAY_PORT, play.tcpPort()); // told to the players
        all.add(play);
        if (impairment != null) {
          play.simulate(impairment);
        }
      }
      return ServerTransports.of(all.get(0), all.subList(1, all.size()));
    } catch (IOException e) {
      all.forEach(ServerTransport::close);
      throw new StartFailure(e.getMessage(), e);
    }
  }

  /** Returns the door for stock KryoNet, which the server owns, or null if there is none. */
  PlainDoor plain() {
    return plain;
  }

  /** Returns the play port, which the server owns, or null if there is none. */
  PlayPort play() {
    return play;
  }

  private ServerTransport openOwnPorts(List<RoomConfig> rooms) throws StartFailure {
    ServerTransport transport;
    Impairment impairment = flags.impairment();
    try {
      KryoLimits limits = flags.limits(RoomConfig.places(rooms));
      transport =
          new KryoServerTransport(
              flags.bindAddresses(),
              podPort(ServerConfig.TCP_PORT, GameServer.TCP),
              podPort(ServerConfig.UDP_PORT, GameServer.UDP),
              limits,
              identity(),
              impairment == null ? Impairment.NONE : impairment,
              proxies());
    } catch (IllegalArgumentException e) {
      throw flags.bad("--room: " + e.getMessage());
    } catch (PortUnavailableException e) {
      throw new StartFailure(e.getMessage(), e);
    }
    if (impairment != null) {
      log.warn("network: made bad on purpose, each way: {}", impairment);
      transport =
          new ImpairedServerTransport(
              transport, impairment, new KryoMessageCodec(), System::nanoTime);
    }
    return transport;
  }

  private ProxyRule proxies() {
    List<AddressRange> networks = flags.proxies();
    return networks.isEmpty()
        ? ProxyRule.NONE
        : new ProxyRule(
            address -> networks.stream().anyMatch(n -> n.contains(address.getAddress())),
            text -> log.warn("proxy: closed connections without a PROXY header: {}", text));
  }

  /** Returns the key in the data folder and whether links are encrypted, and logs both. */
  private ServerIdentity identity() throws StartFailure {
    try {
      Encryption encryption = flags.get(ServerConfig.ENCRYPTION);
      ServerIdentity identity =
          FleetFlags.isFleet(config)
              ? new ServerIdentity(encryption, ServerKey.load(flags.get(ServerConfig.FLEET_KEY)))
              : flags.dataFolder().identity(encryption);
      String fingerprint = identity.fingerprint();
      Secret.warnIfShared(flags.dataFolder().serverKey());
      access.demandTokens(
          flags.get(ServerConfig.JOIN_KEY), fingerprint, flags.get(ServerConfig.TOKEN_USES));
      String meaning = flags.get(ServerConfig.ENCRYPTION).meaning();
      log.info("identity: players know this server by {}; {}", fingerprint, meaning);
      return identity;
    } catch (IOException e) {
      throw new StartFailure(e.getMessage(), e);
    }
  }

  /** Returns what keeps levels of players, or null if the server takes none. */
  private Uploads uploads() {
    try {
      return config.get(ServerConfig.UPLOADS)
          ? new Uploads(flags.dataFolder().uploads(), InstantSource.system(), System::nanoTime)
          : null;
    } catch (IOException e) {
      throw flags.bad(e.getMessage());
    }
  }

  private Server openRooms(List<RoomConfig> rooms, ServerTransport transport) {
    try {
      Uploads uploads = uploads();
      MatchLibrary known = choice.library();
      MatchLibrary library =
          MatchLibrary.heard(
              uploads == null ? known : uploads.library(known), steps::incrementAndGet);
      Server opened =
          new Server(
              config,
              rooms,
              library,
              transport,
              System::nanoTime,
              fleet == null ? room -> Ownership.alone() : fleet.member()::ownershipOf);
      opened.uploads(uploads);
      return opened;
    } catch (IllegalArgumentException e) {
      transport.close();
      throw flags.bad(e.getMessage());
    }
  }

  /** Returns a number that changes whenever the start gets on; any thread. */
  int progress() {
    Server begun = server;
    return steps.get() + (begun == null ? 0 : (int) begun.count(Counter.TICKS_REPLAYED));
  }

  /** Returns what plays bots: clients that come to this server's own ports. */
  private BotCrew bots() {
    String problem = config.get(ServerConfig.BOTS).isEmpty() ? null : BotProcess.problem();
    if (problem != null) {
      throw flags.bad(problem);
    }
    InetAddress here =
        flags.bindAddresses().stream()
            .filter(address -> !address.isAnyLocalAddress())
            .findFirst()
            .orElse(InetAddress.getLoopbackAddress());
    String address = here.getHostAddress();
    List<String> own = new ArrayList<>();
    own.add("--host");
    own.add(
        (here instanceof Inet6Address ? "[" + address + "]" : address)
            + (":" + server.tcpPort() + "/" + server.udpPort()));
    own.addAll(
        List.of(
            "--encryption", flags.get(ServerConfig.ENCRYPTION).name().toLowerCase(Locale.ROOT)));
    if (config.get(ServerConfig.DEV)) {
      own.add("--dev");
    }
    Path logs = flags.dataFolder().logs();
    return new BotProcess(own, Files.isDirectory(logs) ? logs.resolve("bots.log") : null);
  }

  private void demandPassword() throws StartFailure {
    if (flags.get(ServerConfig.PASSWORD_FILE) == null) {
      return;
    }
    try {
      Secret secret = Secret.of(flags.get(ServerConfig.PASSWORD_FILE));
      server.demand(new GamePassword(secret, new LoginThrottle(System::nanoTime)));
      log.info("password: players must know what is in {}", flags.get(ServerConfig.PASSWORD_FILE));
    } catch (IOException e) {
      throw new StartFailure("--password-file: " + e.getMessage(), e);
    }
  }

  /** Sets what keeps accounts. The store is asked when the first player with an account comes. */
  private void remember() throws StartFailure {
    String store = config.get(ServerConfig.STORE);
    if (store.equals(ServerConfig.NO_STORE)) {
      return;
    }
    try {
      boolean own = store.equals(ServerConfig.STORE.initial());
      if (own && !Files.isWritable(flags.dataFolder().root())) {
        log.warn("accounts: nobody is remembered without a data folder");
        return;
      }
      JdbcAccounts accounts =
          own ? JdbcAccounts.file(flags.dataFolder().accounts()) : JdbcAccounts.postgres(store);
      if (own && FleetFlags.isFleet(config)) {
        log.warn(
            "accounts: each server of the fleet keeps its own in its data folder; --store"
                + " postgresql://... keeps them together");
      }
      log.info("accounts: kept in {}", accounts.title());
      AccountService service = new AccountService(accounts, System::nanoTime);
      server.accounts(service);
      service.start();
    } catch (IOException e) {
      throw flags.bad(e.getMessage());
    }
  }

  private void keep() throws StartFailure {
    if (flags.get(ServerConfig.CHECKPOINT) == 0) {
      return;
    }
    Path folder = flags.dataFolder().checkpoints();
    try {
      server.checkpoint(folder, flags.get(ServerConfig.CHECKPOINT));
      log.info("checkpoints: {}, every {} s", folder, flags.get(ServerConfig.CHECKPOINT));
    } catch (IOException e) {
      throw new StartFailure("--checkpoint: " + FileErrors.reason(e), e);
    }
  }

  private void record() throws StartFailure {
    Path target = flags.record();
    if (target == null) {
      return;
    }
    RotationLimit rotation = flags.rotation();
    try {
      if (flags.recordsToFolder()) {
        Files.createDirectories(target);
      }
      if (rotation.rotates()) {
        server.recordRotating(target, rotation, flags.get(ServerConfig.RECORD_KEEP));
        log.info("recording: {}, another file every {}", target, rotation);
      } else {
        server.record(target).forEach(file -> log.info("recording: {}", file));
      }
    } catch (FileAlreadyExistsException e) {
      throw flags.bad("--record=" + target + " is there already; name a new file or a folder");
    } catch (IOException e) {
      throw new StartFailure(
          "--record=" + target + " can't be written: " + FileErrors.reason(e), e);
    } catch (IllegalArgumentException e) {
      throw flags.bad("--record-rotate: " + e.getMessage());
    }
  }

  private void show() throws StartFailure {
    if (flags.get(ServerConfig.SPECTATOR_DELAY) == 0) {
      return;
    }
    try {
      server.allowSpectators(flags.get(ServerConfig.SPECTATOR_DELAY));
      log.info("spectators: let in, {} s late", flags.get(ServerConfig.SPECTATOR_DELAY));
    } catch (IOException e) {
      throw new StartFailure(
          "--spectator-delay: no file for the recording: " + FileErrors.reason(e), e);
    }
  }
}
