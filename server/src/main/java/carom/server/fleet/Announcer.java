package carom.server.fleet;

import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.server.directory.Directory;
import carom.server.directory.DirectoryException;
import carom.server.room.FleetRoom;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * Tells the directory what this server and its rooms are, and the clients where they may go if the
 * server is lost. The fleet's thread, but for {@link #soon}.
 */
final class Announcer {
  private static final long PUBLISH_NS = 250 * 1_000_000L;
  private static final long SERVER_NS = 4 * PUBLISH_NS;

  /** Loads are told in steps of so many percent, so that entries rest while rooms do. */
  private static final int LOAD_STEP = 10;

  /** Steps in which this server's load is told, percent. */
  private static final int SHARE_STEP = 5;

  private final Directory directory;
  private final FleetSettings settings;
  private final LongSupplier clock;
  private final Lease lease;
  private final Claims claims;
  private final FleetView view;
  private final Placement placement;
  private String peerAddress = "";
  private String kind = "";
  private int rooms;
  private long born; // the first lease
  private long serverNumber;
  private String serverTold = "";
  private volatile long serverNextNs;
  private long clientsNextNs;

  Announcer(
      Directory directory,
      FleetSettings settings,
      LongSupplier clock,
      Lease lease,
      Claims claims,
      FleetView view,
      Placement placement) {
    this.directory = directory;
    this.settings = settings;
    this.clock = clock;
    this.lease = lease;
    this.claims = claims;
    this.view = view;
    this.placement = placement;
  }

  /** Sets where other servers reach this one, {@code host:port}; before the first announcement. */
  void reachedAt(String address) {
    peerAddress = address;
  }

  /** Sets for how many numbered rooms this server was started; told with the next announcement. */
  void startedFor(String kindOfRooms, int count) {
    kind = kindOfRooms;
    rooms = count;
    soon(0);
  }

  /** Begins anew under a lease that has just begun. */
  void begin() {
    born = born == 0 ? lease.number() : born;
    serverNumber = 0;
  }

  /** Returns whether the directory has been told about the server under the present lease. */
  boolean isKnown() {
    return serverNumber != 0;
  }

  /** Lets the next announcement of the server come within a time, ns. Any thread. */
  void soon(long ns) {
    serverNextNs = Math.min(serverNextNs, clock.getAsLong() + ns);
  }

  /**
   * Tells about the server, if it is time.
   *
   * @param host its rooms, null while it has none
   */
  void tellServer(RoomHost host, boolean draining, long nowNs) throws DirectoryException {
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
            kind,
            rooms,
            placement.lookers(),
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
  double share(List<? extends FleetRoom> rooms) {
    double share = 0;
    for (FleetRoom room : rooms) {
      share += room.loadPercent() / (double) settings.processors();
    }
    return Math.min(Balance.FULL_PERCENT, share);
  }

  static int stepped(double load, int step) {
    return (int) load / step * step;
  }

  /**
   * Tells the directory what has changed in the rooms, and releases those that are gone.
   *
   * @param isHindered returns whether something else can't wait any longer
   * @param lose hears of claims that are another server's by now
   */
  void tellRooms(
      Map<String, FleetRoom> rooms,
      long nowNs,
      BooleanSupplier isHindered,
      Consumer<Claims.Claim> lose)
      throws DirectoryException {
    for (Claims.Claim claim : claims.all()) {
      if (isHindered.getAsBoolean()) {
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
          lose.accept(claim);
        }
      }
    }
  }

  private List<String> accountsOf(FleetRoom room) {
    return !settings.limitsSeats()
        ? List.of()
        : room.accounts().stream().limit(RoomRecord.MAX_ACCOUNTS).map(RoomRecord::hashed).toList();
  }

  /** Tells the clients where to go if this server is lost. */
  void tellClients(Map<String, FleetRoom> rooms, long nowNs) {
    if (nowNs - clientsNextNs < 0) {
      return;
    }
    clientsNextNs = nowNs + PUBLISH_NS;
    for (Link.Door door : Link.Door.values()) {
      List<String> addresses = new ArrayList<>();
      for (ServerRecord server : view.servers().values()) {
        String address = server.address(door);
        if (server.takesRoomsOf(lease.number())
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
}
