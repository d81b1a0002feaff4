package carom.server.fleet;

import carom.server.metrics.Figure;
import carom.server.room.FleetRoom;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.DoubleSupplier;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * A fleet as one of its servers sees it, for the operators' page and the metrics. Any thread; each
 * answer is a copy.
 */
public final class FleetFigures {
  /** Most rooms of a {@link #report}. */
  public static final int MOST_ROOMS = 500;

  /** Steps of the lag that servers tell each other, ticks. */
  public static final int LAG_STEP = RoomRecord.LAG_STEP;

  private static final double NS_PER_S = 1e9;

  /**
   * A histogram of durations.
   *
   * @param limits upper ends of its buckets, s; the last is infinite
   * @param counts of each bucket alone
   * @param sum of all durations, s
   */
  public record Durations(List<Double> limits, List<Long> counts, double sum) {
    /** Copies the lists. */
    public Durations {
      limits = List.copyOf(limits);
      counts = List.copyOf(counts);
    }
  }

  /**
   * A server of the fleet.
   *
   * @param name its name, for people
   * @param address where players reach it
   * @param isSelf whether it is this one
   * @param draining whether it takes no rooms and players
   * @param load the part of its processors that its rooms' ticks take, percent
   * @param rooms that it owns
   * @param follows rooms of others that it follows
   * @param players in its rooms
   */
  public record ServerRow(
      String name,
      String address,
      boolean isSelf,
      boolean draining,
      int load,
      int rooms,
      int follows,
      int players) {}

  /**
   * A room of the fleet.
   *
   * @param name of the room
   * @param game that it plays
   * @param level that it plays
   * @param owner name of its server, empty if that has just gone
   * @param claim number of the owner's claim
   * @param follower name of the server that follows it, empty for none
   * @param lag how many ticks the follower may lack
   * @param isLagExact false for other servers' rooms, whose lag is rounded down to whole {@value
   *     #LAG_STEP} ticks
   * @param players in the room
   * @param skill mean skill of those whose skill is known, or null
   * @param places for players
   */
  public record RoomRow(
      String name,
      String game,
      String level,
      String owner,
      long claim,
      String follower,
      int lag,
      boolean isLagExact,
      int players,
      Integer skill,
      int places) {}

  /**
   * Something that happened.
   *
   * @param ageS seconds ago
   * @param text what, for people
   */
  public record Happening(double ageS, String text) {}

  /**
   * The fleet at one moment.
   *
   * @param servers all of them
   * @param rooms the first {@value #MOST_ROOMS} by name
   * @param allRooms how many there are
   * @param happenings the latest first
   * @param leaseS time that this server's lease still holds, s
   * @param directoryUp whether the directory answers
   */
  public record Report(
      List<ServerRow> servers,
      List<RoomRow> rooms,
      int allRooms,
      List<Happening> happenings,
      double leaseS,
      boolean directoryUp) {
    /** Copies the lists. */
    public Report {
      servers = List.copyOf(servers);
      rooms = List.copyOf(rooms);
      happenings = List.copyOf(happenings);
    }
  }

  private final FleetView view;
  private final Claims claims;
  private final Following following;
  private final Lease lease;
  private final CountedDirectory directory;
  private final FleetNews news;
  private final LongSupplier clock;
  private final Supplier<List<? extends FleetRoom>> rooms;

  /**
   * Creates figures of a member's parts.
   *
   * @param clock as the news have it
   * @param rooms returns this server's rooms
   */
  FleetFigures(
      FleetView view,
      Claims claims,
      Following following,
      Lease lease,
      CountedDirectory directory,
      FleetNews news,
      LongSupplier clock,
      Supplier<List<? extends FleetRoom>> rooms) {
    this.view = view;
    this.claims = claims;
    this.following = following;
    this.lease = lease;
    this.directory = directory;
    this.news = news;
    this.clock = clock;
    this.rooms = rooms;
  }

  /** Returns the numbers for the metrics; their values are read when they are asked for. */
  public List<Figure> all() {
    return List.of(
        gauge("servers", "Servers of the fleet that this one knows, itself too.", this::servers),
        gauge("rooms.owned", "Rooms that this server owns.", () -> claims.all().size()),
        gauge(
            "rooms.followed",
            "Rooms of this server that another one could go on with now.",
            () -> lags().size()),
        gauge(
            "rooms.following",
            "Rooms of other servers that this one follows.",
            () -> following.rooms().size()),
        gauge(
            "lease.left.seconds",
            "Time that this server's lease still holds, less the margin; 0 stops its rooms.",
            () -> lease.leftNs() / NS_PER_S),
        gauge(
            "directory.up",
            "1 if the directory answered the last request.",
            () -> directory.isUp() ? 1 : 0),
        count("directory.requests", "Requests to the directory.", directory::requests),
        count(
            "directory.requests.failed",
            "Requests to the directory without an answer.",
            directory::failures),
        count("claims.won", "Claims of rooms that this server made.", news.claimsWon::get),
        count(
            "claims.refused",
            "Claims that this server tried while another one owned the room.",
            news.claimsRefused::get),
        count(
            "claims.lost",
            "Rooms that this server owned and another one took.",
            news.claimsLost::get),
        count("rooms.moved.in", "Rooms that others handed over to it.", news.movedIn::get),
        count("rooms.moved.out", "Rooms that it handed over to others.", news.movedOut::get),
        count("deaths", "Other servers that it saw go without draining.", news.deaths::get));
  }

  private static Figure gauge(String name, String help, DoubleSupplier value) {
    return new Figure(name, help, true, value);
  }

  private static Figure count(String name, String help, LongSupplier value) {
    return new Figure(name, help, false, value::getAsLong);
  }

  private int servers() {
    return view.servers().size();
  }

  /**
   * Returns the time that takeovers took, from the end of the owner's claim to the room's return.
   */
  public Durations takeovers() {
    return news.takeovers();
  }

  /** Returns how many ticks the follower may lack, for each room of this server that has one. */
  public Map<String, Integer> lags() {
    Map<String, Integer> lags = new TreeMap<>();
    for (FleetRoom room : rooms.get()) {
      if (room.isFollowed()) {
        lags.put(room.name(), room.followerLag());
      }
    }
    return lags;
  }

  /** Returns the fleet as it is now. */
  public Report report() {
    FleetCommands.Snapshot snapshot = new FleetCommands.Snapshot(view);
    List<ServerRow> servers = new ArrayList<>();
    for (ServerRecord server : snapshot.servers.values()) {
      FleetCommands.Sums sums = snapshot.sums(server);
      servers.add(
          new ServerRow(
              server.name(),
              server.address(),
              server.lease() == lease.number(),
              server.draining(),
              server.load(),
              sums.rooms(),
              sums.follows(),
              sums.players()));
    }
    Map<String, Integer> lags = lags();
    List<RoomRow> rows = new ArrayList<>();
    for (Map.Entry<String, RoomRecord> one : snapshot.rooms.entrySet()) {
      if (rows.size() == MOST_ROOMS) {
        break;
      }
      RoomRecord room = one.getValue();
      rows.add(
          new RoomRow(
              one.getKey(),
              room.entry().game(),
              room.entry().level(),
              snapshot.name(room.server()),
              snapshot.claims.get(one.getKey()),
              snapshot.name(room.follower()),
              lags.getOrDefault(one.getKey(), room.lag()),
              lags.containsKey(one.getKey()),
              room.entry().players(),
              room.skill() == null || room.skill().players() == 0 ? null : room.skill().mean(),
              room.entry().places()));
    }
    List<Happening> happenings = new ArrayList<>();
    long nowNs = clock.getAsLong();
    for (FleetNews.Happening one : news.happenings()) {
      happenings.add(new Happening((nowNs - one.atNs()) / NS_PER_S, one.text()));
    }
    return new Report(
        servers,
        rows,
        snapshot.rooms.size(),
        happenings,
        lease.leftNs() / NS_PER_S,
        directory.isUp());
  }
}
