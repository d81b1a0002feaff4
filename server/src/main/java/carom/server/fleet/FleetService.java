package carom.server.fleet;

import carom.net.seal.ExchangeKey;
import carom.net.seal.ServerKey;
import carom.server.access.SharedList;
import carom.server.config.DataFolder;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.directory.Directories;
import carom.server.directory.Directory;
import carom.server.directory.DirectoryTls;
import java.io.IOException;
import java.net.InetAddress;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Runs a server's {@link FleetMember}: its directory, its port for other servers, its threads. */
public final class FleetService implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(FleetService.class);
  private static final long NAP_MS = 25;
  private static final int ASKS = 8;

  private final Directory directory;
  private final FleetMember member;
  private final TcpPeers peers;
  private final String reachedAt;
  private final ExecutorService asks;
  private final ExecutorService builds;
  private final Object bell = new Object();
  private boolean rung; // guarded by bell
  private volatile boolean closed;
  private final Thread thread = new Thread(this::run, "carom-fleet");

  private FleetService(
      Directory directory,
      FleetSettings settings,
      ExchangeKey key,
      InetAddress bind,
      int port,
      String peer)
      throws IOException {
    this.directory = directory;
    asks = threads(ASKS, "carom-fleet-asks-");
    builds = threads(Runtime.getRuntime().availableProcessors(), "carom-fleet-builds-");
    member = new FleetMember(directory, settings, System::nanoTime, asks, builds, this::ring);
    peers = new TcpPeers(bind, port, key, member::number, member.inbox());
    String address = settings.address();
    String host = address.substring(0, address.lastIndexOf(':'));
    reachedAt = peer == null ? host + ":" + peers.port() : peer;
    member.reachesBy(peers, reachedAt);
  }

  private static ExecutorService threads(int count, String name) {
    AtomicInteger number = new AtomicInteger();
    return Executors.newFixedThreadPool(
        count,
        task -> {
          Thread made = new Thread(task, name + number.incrementAndGet());
          made.setDaemon(true);
          made.setPriority(Thread.MAX_PRIORITY); // players wait for what they do
          return made;
        });
  }

  /**
   * Joins a fleet.
   *
   * @param config with {@code --fleet} and what belongs to it
   * @param key the fleet's
   * @param bind address of this machine for the port of the fleet, or null for all
   * @param tcpPort the server's port for players
   * @param play address of its play port for players, empty if they reach none
   * @param plain address of its door for stock KryoNet, the same
   * @param peer where other servers reach this one's fleet port, {@code host:port}; null for the
   *     host of {@code --advertise} and that port
   * @param data folder for what the server keeps of the fleet
   * @param shared lists that are the same on all servers
   * @throws IOException if the directory or the port can't be used; the message says why
   */
  public static FleetService join(
      ServerConfig config,
      ExchangeKey key,
      InetAddress bind,
      int tcpPort,
      String play,
      String plain,
      String peer,
      DataFolder data,
      List<SharedList> shared)
      throws IOException {
    String advertise = config.get(ServerConfig.ADVERTISE);
    String address = FleetFlags.address(advertise, tcpPort);
    FleetSettings settings =
        new FleetSettings(
            address,
            address,
            play,
            plain,
            ServerKey.fingerprint(key.publicKey()),
            config.get(ServerConfig.JOIN_KEY) != null && config.get(ServerConfig.TOKEN_USES) > 0,
            config.get(ServerConfig.ON_PARTITION) == ServerConfig.OnPartition.KEEP,
            (int) Math.round(100 * config.get(ServerConfig.MAX_LOAD)),
            Runtime.getRuntime().availableProcessors(),
            config.get(ServerConfig.DURABILITY),
            data.followed());
    Directory directory =
        Directories.open(
            config.get(ServerConfig.FLEET),
            new DirectoryTls(
                config.get(ServerConfig.DIRECTORY_CA),
                config.get(ServerConfig.DIRECTORY_CERT),
                config.get(ServerConfig.DIRECTORY_KEY)));
    FleetService service = null;
    try {
      service =
          new FleetService(
              directory, settings, key, bind, config.get(ServerConfig.FLEET_PORT), peer);
      service.member.shares(data.agreed(), shared);
      service.member.keepsSaves(data);
      service.member.join();
      service.start();
      LOG.info(
          "fleet: this server is {} in {}; other servers reach it at {}",
          address,
          config.get(ServerConfig.FLEET).replaceAll("//[^/@]*@", "//"),
          service.reachedAt);
      return service;
    } catch (IOException | RuntimeException e) {
      if (service != null) {
        service.close();
      } else {
        directory.close();
      }
      throw e;
    }
  }

  /** Returns this server's part in the fleet. */
  public FleetMember member() {
    return member;
  }

  /**
   * Claims the server's own rooms, see {@link FleetMember#claim}.
   *
   * @throws IOException if the directory doesn't answer
   */
  public List<RoomConfig> claim(List<RoomConfig> rooms, boolean numbered, Runnable step)
      throws IOException {
    return member.claim(rooms, numbered, step);
  }

  private void ring() {
    synchronized (bell) {
      rung = true;
      bell.notifyAll();
    }
  }

  /** Serves the rooms of a server from now on. */
  public void serve(RoomHost host) {
    member.serves(host);
    ring();
  }

  private void start() {
    thread.setDaemon(true);
    thread.setPriority(Thread.MAX_PRIORITY); // a lease that isn't renewed stops every room
    thread.start();
  }

  private void run() {
    while (!closed) {
      try {
        member.turn(System.nanoTime());
      } catch (RuntimeException e) {
        LOG.error("the fleet's thread survived an error", e);
      }
      synchronized (bell) {
        try {
          if (!rung) {
            bell.wait(NAP_MS);
          }
        } catch (InterruptedException e) {
          return;
        }
        rung = false;
      }
    }
  }

  /**
   * Moves all rooms to other servers, and waits until they are gone.
   *
   * @param mostMs longest time to wait for the next room to go, ms: a directory may be slow, and
   *     rooms are many
   * @return whether they are
   */
  public boolean drain(int mostMs) {
    if (!member.isServing()) {
      return true;
    }
    member.drain();
    long mostNs = TimeUnit.MILLISECONDS.toNanos(mostMs);
    while (!member.isDrained() && member.stillNs() < mostNs && !closed) {
      try {
        Thread.sleep(5);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return false;
      }
    }
    return member.isDrained();
  }

  /** Leaves the fleet. */
  @Override
  public void close() {
    closed = true;
    ring();
    member.close();
    asks.shutdownNow();
    builds.shutdownNow();
    directory.close();
  }
}
