package carom.server.fleet;

import carom.server.directory.Directory;
import carom.server.directory.DirectoryEntry;
import carom.server.directory.DirectoryException;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/** Shows a fleet to operators, at one of its servers or from anywhere. Any thread. */
final class FleetCommands {
  private FleetCommands() {}

  /** Returns the servers of a fleet as lines of text. */
  static String status(Iterable<ServerRecord> servers, Map<String, RoomRecord> rooms) {
    List<String> lines = new ArrayList<>();
    lines.add(row("server", "rooms", "players", "follows", "load", "state"));
    int count = 0;
    for (ServerRecord server : servers) {
      int owned = 0;
      int players = 0;
      int follows = 0;
      for (RoomRecord room : rooms.values()) {
        boolean own = room.server() == server.lease();
        owned += own ? 1 : 0;
        players += own ? room.entry().players() : 0;
        follows += room.follower() == server.lease() ? 1 : 0;
      }
      count++;
      lines.add(
          row(
              server.name(),
              String.valueOf(owned),
              String.valueOf(players),
              String.valueOf(follows),
              server.load() + " %",
              server.draining() ? "draining" : "up"));
    }
    lines.add(String.format(Locale.ROOT, "servers=%d rooms=%d", count, rooms.size()));
    return String.join("\n", lines);
  }

  private static String row(
      String server, String rooms, String players, String follows, String load, String state) {
    return String.format(
        Locale.ROOT, "%-28s %6s %8s %8s %6s  %s", server, rooms, players, follows, load, state);
  }

  /** Returns the rooms of a fleet as lines of text. */
  static String rooms(
      Map<Long, ServerRecord> servers, Map<String, RoomRecord> rooms, Map<String, Long> claims) {
    List<String> lines = new ArrayList<>();
    String format = "%-20s %9s  %-20s %8s  %-28s %s";
    lines.add(
        String.format(
            Locale.ROOT, format, "room", "players", "level", "claim", "owner", "follower"));
    for (Map.Entry<String, RoomRecord> one : rooms.entrySet()) {
      RoomRecord room = one.getValue();
      lines.add(
          String.format(
              Locale.ROOT,
              format,
              one.getKey(),
              room.entry().players() + "/" + room.entry().places(),
              room.entry().level(),
              claims.get(one.getKey()),
              name(servers, room.server()),
              room.follower() == 0 ? "none yet" : name(servers, room.follower())));
    }
    return String.join("\n", lines);
  }

  private static String name(Map<Long, ServerRecord> servers, long lease) {
    ServerRecord server = servers.get(lease);
    return server == null ? "gone" : server.name();
  }

  /** A fleet as its directory has it now. */
  static final class Snapshot {
    final Map<Long, ServerRecord> servers = new TreeMap<>();
    final Map<String, RoomRecord> rooms = new TreeMap<>();
    final Map<String, Long> claims = new TreeMap<>();

    Snapshot(Directory directory) throws IOException {
      for (DirectoryEntry entry : directory.list(ServerRecord.PREFIX)) {
        long lease = Long.parseLong(entry.key().substring(ServerRecord.PREFIX.length()));
        servers.put(lease, ServerRecord.parse(lease, entry.value()));
      }
      for (DirectoryEntry entry : directory.list(RoomRecord.PREFIX)) {
        String room = entry.key().substring(RoomRecord.PREFIX.length());
        rooms.put(room, RoomRecord.parse(entry.value()));
        claims.put(room, entry.number());
      }
    }

    Snapshot(FleetView view) {
      servers.putAll(view.servers());
      view.rooms()
          .forEach(
              (name, owned) -> {
                rooms.put(name, owned.record());
                claims.put(name, owned.claim());
              });
    }

    String status() {
      return FleetCommands.status(servers.values(), rooms);
    }

    String roomList() {
      return FleetCommands.rooms(servers, rooms, claims);
    }

    /** Returns the server of a name. */
    ServerRecord server(String name) throws DirectoryException {
      for (ServerRecord server : servers.values()) {
        if (server.name().equals(name)) {
          return server;
        }
      }
      List<String> names = servers.values().stream().map(ServerRecord::name).toList();
      throw new DirectoryException(
          "server=" + name + " isn't in the fleet; it has " + String.join(", ", names), null);
    }
  }
}
