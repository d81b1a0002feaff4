package carom.server.fleet;

import carom.server.directory.Directory;
import carom.server.directory.DirectoryEntry;
import carom.server.directory.DirectoryException;
import carom.server.session.RoomSkill;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/** Shows a fleet to operators, at one of its servers or from anywhere. Any thread. */
final class FleetCommands {
  private FleetCommands() {}

  /**
   * The share of a server in its fleet.
   *
   * @param rooms that it owns
   * @param players in them
   * @param follows rooms of others that it follows
   */
  record Sums(int rooms, int players, int follows) {}

  private static String row(
      String server, String rooms, String players, String follows, String load, String state) {
    return String.format(
        Locale.ROOT, "%-28s %6s %8s %8s %6s  %s", server, rooms, players, follows, load, state);
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

    /** Returns the share of a server. */
    Sums sums(ServerRecord server) {
      int owned = 0;
      int players = 0;
      int follows = 0;
      for (RoomRecord room : rooms.values()) {
        boolean own = room.server() == server.lease();
        owned += own ? 1 : 0;
        players += own ? room.entry().players() : 0;
        follows += room.follower() == server.lease() ? 1 : 0;
      }
      return new Sums(owned, players, follows);
    }

    /** Returns the name of a server; empty for none, or one that has gone. */
    String name(long lease) {
      ServerRecord server = servers.get(lease);
      return server == null ? "" : server.name();
    }

    /** Returns the servers as lines of text. */
    String status() {
      List<String> lines = new ArrayList<>();
      lines.add(row("server", "rooms", "players", "follows", "load", "state"));
      for (ServerRecord server : servers.values()) {
        Sums sums = sums(server);
        lines.add(
            row(
                server.name(),
                String.valueOf(sums.rooms()),
                String.valueOf(sums.players()),
                String.valueOf(sums.follows()),
                server.load() + " %",
                server.draining() ? "draining" : "up"));
      }
      lines.add(String.format(Locale.ROOT, "servers=%d rooms=%d", servers.size(), rooms.size()));
      return String.join("\n", lines);
    }

    /** Returns the rooms as lines of text. */
    String roomList() {
      List<String> lines = new ArrayList<>();
      String format = "%-20s %9s %7s  %-20s %8s  %-28s %s";
      lines.add(
          String.format(
              Locale.ROOT,
              format,
              "room",
              "players",
              "skill",
              "level",
              "claim",
              "owner",
              "follower"));
      for (Map.Entry<String, RoomRecord> one : rooms.entrySet()) {
        RoomRecord room = one.getValue();
        String follower = name(room.follower());
        lines.add(
            String.format(
                Locale.ROOT,
                format,
                one.getKey(),
                room.entry().players() + "/" + room.entry().places(),
                skill(room),
                room.entry().level(),
                claims.get(one.getKey()),
                servers.containsKey(room.server()) ? name(room.server()) : "gone",
                follower.isEmpty() ? "none yet" : follower));
      }
      return String.join("\n", lines);
    }

    private static String skill(RoomRecord room) {
      RoomSkill skill = room.skill();
      return skill == null || skill.players() == 0 ? "-" : String.valueOf(skill.mean());
    }

    /**
     * Returns the owner of a room.
     *
     * @throws DirectoryException if there is none; the message says so
     */
    ServerRecord owner(String room) throws DirectoryException {
      RoomRecord record = rooms.get(room);
      ServerRecord owner = record == null ? null : servers.get(record.server());
      if (owner == null) {
        throw new DirectoryException(
            "room=" + room + " isn't in the fleet; 'fleet rooms' lists all", null);
      }
      return owner;
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
