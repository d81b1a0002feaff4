package carom.server.fleet;

import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.server.room.FleetDoor;
import carom.text.Json;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * The record of a server in the directory, by itself.
 *
 * @param lease its lease, which is its number in the fleet: another one after each start
 * @param born the first lease of its process, by which the others know it again when it lost one
 * @param name name of the server, for people
 * @param address host and TCP port for players, as {@code ServerAddress} reads it
 * @param play host and port of its play port, empty for none
 * @param plain host, TCP port and perhaps UDP port for stock KryoNet, empty for none
 * @param peer host and port for the other servers of the fleet
 * @param load the part of its processors that its rooms' ticks take, percent
 * @param kind what kind of numbered rooms it was started for, see {@link RoomRecord#kind}; empty
 *     for none
 * @param rooms how many of them it was started for
 * @param lookers players who look for players about as good there, at most {@value #MAX_LOOKERS}
 * @param draining whether it takes no rooms and no newcomers, because it is about to stop
 */
public record ServerRecord(
    long lease,
    long born,
    String name,
    String address,
    String play,
    String plain,
    String peer,
    int load,
    String kind,
    int rooms,
    List<FleetDoor.Looker> lookers,
    boolean draining) {
  /** Begins the keys of servers in the directory. */
  static final String PREFIX = "servers/";

  /** Most lookers of which a record tells, so that it stays small. */
  static final int MAX_LOOKERS = 32;

  /**
   * Returns whether it takes rooms of the server that has a lease: of any other one, while it
   * stays.
   */
  boolean takesRoomsOf(long other) {
    return lease != other && !draining;
  }

  /** Returns the address at a door, empty for none. */
  String address(Link.Door door) {
    return switch (door) {
      case OWN -> address;
      case PLAY -> play;
      case PLAIN -> plain;
    };
  }

  /**
   * Returns what sends a client to a room there; null where the server has no such door.
   *
   * @param ticket that lets the client in; empty for a client that has a seat there
   */
  ServerMessage.Redirect redirect(Link.Door door, String room, String ticket) {
    String there = address(door);
    return there.isEmpty() ? null : new ServerMessage.Redirect(there, "", room, ticket);
  }

  /**
   * Returns what sends a client of Carom here.
   *
   * @param fingerprint of the fleet's key
   * @param ticket as above
   */
  ServerMessage.Move move(String fingerprint, String room, String ticket) {
    return new ServerMessage.Move(address(), fingerprint, room, ticket);
  }

  /** Returns the host of {@link #peer}. */
  String peerHost() {
    String host = peer.substring(0, Math.max(0, peer.lastIndexOf(':')));
    return host.startsWith("[") ? host.substring(1, host.length() - 1) : host;
  }

  /** Returns the port of {@link #peer}, 0 if it has none. */
  int peerPort() {
    return peer.matches(".+:\\d{1,5}")
        ? Integer.parseInt(peer.substring(peer.lastIndexOf(':') + 1))
        : 0;
  }

  String key() {
    return PREFIX + lease;
  }

  String toJson() {
    return FleetJson.write(
        json -> {
          json.writeNumberField("born", born);
          json.writeStringField("name", name);
          json.writeStringField("address", address);
          json.writeStringField("play", play);
          json.writeStringField("plain", plain);
          json.writeStringField("peer", peer);
          json.writeNumberField("load", load);
          json.writeStringField("kind", kind);
          json.writeNumberField("rooms", rooms);
          if (!lookers.isEmpty()) {
            json.writeArrayFieldStart("lookers");
            for (FleetDoor.Looker looker : lookers) {
              json.writeStartObject();
              json.writeStringField("game", looker.game());
              json.writeNumberField("skill", looker.skill());
              json.writeEndObject();
            }
            json.writeEndArray();
          }
          json.writeBooleanField("draining", draining);
        });
  }

  /**
   * Reads a record.
   *
   * @throws IOException if it is none; the message says why
   */
  static ServerRecord parse(long lease, String value) throws IOException {
    Json json = FleetJson.read(value);
    List<FleetDoor.Looker> lookers = new ArrayList<>();
    for (Json looker :
        json.fields.containsKey("lookers") ? json.fields.get("lookers").items : List.<Json>of()) {
      lookers.add(
          new FleetDoor.Looker(FleetJson.text(looker, "game"), FleetJson.whole(looker, "skill")));
    }
    return new ServerRecord(
        lease,
        FleetJson.number(json, "born"),
        FleetJson.text(json, "name"),
        FleetJson.text(json, "address"),
        FleetJson.text(json, "play"),
        FleetJson.text(json, "plain"),
        FleetJson.text(json, "peer"),
        FleetJson.whole(json, "load"),
        FleetJson.text(json, "kind"),
        FleetJson.whole(json, "rooms"),
        lookers,
        FleetJson.flag(json, "draining"));
  }
}
