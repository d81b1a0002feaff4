package carom.server.fleet;

import carom.server.config.ServerConfig.Durability;
import java.nio.file.Path;

/**
 * The part of a server's settings that its fleet needs.
 *
 * @param name name of the server, for people
 * @param address host and TCP port at which players reach this server
 * @param play host and port of the play port, empty if other servers send nobody there
 * @param plain the same of the door for stock KryoNet
 * @param fingerprint of the fleet's key
 * @param limitsSeats whether accounts may have a limited number of seats
 * @param keepsRooms whether rooms go on while the directory is away
 * @param maxLoadPercent load above which a room takes no newcomers, 0 for none
 * @param processors how many processors this server has
 * @param durability what outlives this server
 * @param followed folder for the journals of rooms that this server follows
 */
public record FleetSettings(
    String name,
    String address,
    String play,
    String plain,
    String fingerprint,
    boolean limitsSeats,
    boolean keepsRooms,
    int maxLoadPercent,
    int processors,
    Durability durability,
    Path followed) {

  /** Returns what becomes of the rooms while the directory is away, for the log. */
  String onPartition() {
    return keepsRooms
        ? "rooms go on without it (--on-partition keep)"
        : "rooms stand still when the lease is over (--on-partition stop)";
  }
}
