package carom.server;

import carom.net.kryo.server.KryoLimits;
import carom.net.transport.Impairment;
import carom.options.BadFlag;
import carom.options.NetworkConditions;
import carom.options.Setting;
import carom.options.Sockets;
import carom.server.access.AddressRange;
import carom.server.config.DataFolder;
import carom.server.config.EffectiveSettings;
import carom.server.config.ServerConfig;
import carom.server.fleet.FleetFlags;
import carom.server.lobby.Lobby;
import carom.server.query.ProtocolFlags;
import carom.server.recording.RotationLimit;
import carom.server.thin.plain.PlainFlags;
import carom.server.thin.web.PlayFlags;
import carom.server.web.WebFlags;
import java.io.File;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine;

/**
 * The settings with which {@code carom-server} was started. {@link #check} refuses those that don't
 * fit together, and {@link #config} completes them.
 */
final class ServerFlags {
  private final CommandLine program;
  private final EffectiveSettings settings;
  private final ServerConfig config;

  /**
   * Creates flags of a program.
   *
   * @throws BadFlag for the first value that can't be used
   */
  ServerFlags(CommandLine program, EffectiveSettings settings) {
    this.program = program;
    this.settings = settings;
    try {
      config = settings.config();
    } catch (IllegalArgumentException e) {
      throw bad(e.getMessage());
    }
  }

  /** Returns the value of a setting; null if it isn't set and has no default. */
  <T> T get(Setting<T> row) {
    return config.get(row);
  }

  /** Returns whether a setting isn't as by default. */
  boolean isSet(Setting<?> row) {
    return settings.isSet(row);
  }

  /** Returns the settings with their origins. */
  EffectiveSettings settings() {
    return settings;
  }

  /**
   * Checks the settings against each other.
   *
   * @throws BadFlag for the first flag that can't be used
   */
  void check() {
    for (String network : get(ServerConfig.PROXY_FROM)) {
      if (AddressRange.parse(network).isEmpty()) {
        throw bad("--proxy-from: " + AddressRange.problem(network));
      }
    }
    String problem =
        Sockets.first(
            WebFlags.problem(config),
            PlayFlags.problem(config),
            ProtocolFlags.problem(config),
            PlainFlags.problem(config, bindAddresses()),
            AgonesFlags.problem(config, System.getenv()),
            FleetFlags.problem(config, AgonesFlags.isOn(config, System.getenv())));
    if (problem != null) {
      throw bad(problem);
    }
    String record = get(ServerConfig.RECORD);
    if (record != null && roomCount() > 1 && !recordsToFolder()) {
      throw bad("--record=" + record + " is no folder; rooms=" + roomCount() + " need one");
    }
    checkRotation();
    for (Setting<?> row : List.of(ServerConfig.RCON_PORT, ServerConfig.RCON_BIND)) {
      if (isSet(row) && !get(ServerConfig.RCON)) {
        throw bad(row + "=" + get(row) + " needs --rcon");
      }
    }
    int players = get(ServerConfig.MAX_PLAYERS);
    if (get(ServerConfig.ROOM).isEmpty() && roomCount() * players > ServerConfig.MAX_PLACES) {
      throw bad(
          String.format(
              Locale.ROOT,
              "--rooms=%d with --max-players=%d each are %d places, a server has at most %d; %s",
              roomCount(),
              players,
              roomCount() * players,
              ServerConfig.MAX_PLACES,
              "lower one of them"));
    }
  }

  /**
   * Checks that the flags which say what rooms there are exclude each other.
   *
   * @throws BadFlag when they don't
   */
  void checkRooms() {
    List<String> rooms = get(ServerConfig.ROOM);
    if (!rooms.isEmpty()) {
      for (Setting<?> other :
          List.of(
              ServerConfig.ROOMS,
              ServerConfig.LEVEL,
              ServerConfig.LEVELS,
              ServerConfig.GAME,
              ServerConfig.SCENE)) {
        if (isSet(other)) {
          throw bad(
              "--room and "
                  + other
                  + " exclude each other: each --room names its levels; leave "
                  + other
                  + " out");
        }
      }
      if (rooms.size() > ServerConfig.MAX_ROOMS) {
        throw bad(
            String.format(
                Locale.ROOT,
                "--room is given %d times, a server has 1..%d rooms; leave some out",
                rooms.size(),
                ServerConfig.MAX_ROOMS));
      }
    }
    if (get(ServerConfig.LEVELS) != null) {
      for (Setting<?> other : List.of(ServerConfig.LEVEL, ServerConfig.GAME, ServerConfig.SCENE)) {
        if (isSet(other)) {
          throw bad("--levels and " + other + " exclude each other; leave " + other + " out");
        }
      }
    }
  }

  private int roomCount() {
    int named = get(ServerConfig.ROOM).size();
    return named == 0 ? get(ServerConfig.ROOMS) : named;
  }

  private void checkRotation() {
    boolean rotates = rotation().rotates();
    String limit = get(ServerConfig.RECORD_ROTATE);
    int keep = get(ServerConfig.RECORD_KEEP);
    int delay = get(ServerConfig.SPECTATOR_DELAY);
    if (rotates && !recordsToFolder()) {
      throw bad("--record-rotate=" + limit + " needs a folder; give one by --record");
    }
    if (rotates && delay > 0) {
      throw bad(
          "--record-rotate="
              + limit
              + " can't be combined with --spectator-delay="
              + delay
              + ": spectators see one file; leave one of them out");
    }
    if (keep > 0 && !rotates) {
      throw bad("--record-keep=" + keep + " needs --record-rotate");
    }
  }

  /** Returns the settings of a server that runs this game; call {@link #check} before. */
  ServerConfig config(String gameName) {
    Long seed = get(ServerConfig.SEED);
    return config
        .with(ServerConfig.GAME, gameName)
        .with(ServerConfig.SEED, seed == null ? new SecureRandom().nextLong() : seed)
        .with(ServerConfig.ROOMS, roomCount());
  }

  /**
   * Returns the transport's limits for open links. Those that play, those that wait and those that
   * watch have limits of their own in the lobby; here is room for all of them. A single address may
   * hold all seats, because a whole school may be behind one router.
   *
   * @param places number of seats of all rooms
   */
  KryoLimits limits(int places) {
    return KryoLimits.DEFAULT.withConnections(
        Lobby.mostLinks(places), Lobby.mostLinksOfAddress(places));
  }

  /** Returns the folder of the server's own files. */
  DataFolder dataFolder() {
    return new DataFolder(get(ServerConfig.DATA));
  }

  /** Returns the networks of proxies before the TCP port. */
  List<AddressRange> proxies() {
    return get(ServerConfig.PROXY_FROM).stream()
        .map(network -> AddressRange.parse(network).orElseThrow())
        .toList();
  }

  /** Returns the addresses to listen on, empty for all. */
  List<InetAddress> bindAddresses() {
    return get(ServerConfig.BIND).stream().map(this::address).distinct().toList();
  }

  private InetAddress address(String text) {
    try {
      return InetAddress.getByName(text);
    } catch (UnknownHostException e) {
      throw bad("--bind=" + text + " is no address; give one such as 127.0.0.1 or ::1");
    }
  }

  /** Returns the file or folder of {@code --record}, or null if nothing is recorded. */
  Path record() {
    String record = get(ServerConfig.RECORD);
    try {
      return record == null ? null : Path.of(record);
    } catch (InvalidPathException e) {
      throw bad("--record=" + record + " can't be the name of a file or folder");
    }
  }

  /** Returns whether {@code --record} names a folder: one that is there, or to be made. */
  boolean recordsToFolder() {
    String record = get(ServerConfig.RECORD);
    return record != null
        && (record.endsWith("/") || record.endsWith(File.separator) || Files.isDirectory(record()));
  }

  /** Returns the limit of {@code --record-rotate} for each file. */
  RotationLimit rotation() {
    try {
      return RotationLimit.parse(get(ServerConfig.RECORD_ROTATE));
    } catch (IllegalArgumentException e) {
      throw bad("--record-rotate=" + e.getMessage());
    }
  }

  /** Returns the impairment that the flags ask for, or null if they ask for none. */
  Impairment impairment() {
    return NetworkConditions.isBad(config) ? NetworkConditions.impairment(config) : null;
  }

  /** Returns an exception for the caller to throw: one line on standard error and exit code 2. */
  BadFlag bad(String message) {
    return new BadFlag(program, message);
  }
}
