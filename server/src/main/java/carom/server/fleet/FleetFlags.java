package carom.server.fleet;

import carom.options.Sockets;
import carom.server.config.ServerConfig;
import java.util.regex.Pattern;

/** The settings of a server that concern its fleet, checked against each other. */
public final class FleetFlags {
  /** The value of {@code --fleet} for a server that is alone. */
  public static final String NONE = "none";

  private static final Pattern ADDRESS =
      Pattern.compile("(" + Sockets.HOST + ")(?::(\\d{1,5})(?::(\\d{1,5}))?)?");

  private FleetFlags() {}

  /** Returns whether the server is one of a fleet. */
  public static boolean isFleet(ServerConfig config) {
    return !config.get(ServerConfig.FLEET).equals(NONE);
  }

  /**
   * Returns why the settings can't be used together, or null if they can.
   *
   * @param hasAddress whether the server learns its address without {@code --advertise}
   */
  public static String problem(ServerConfig config, boolean hasAddress) {
    boolean fleet = isFleet(config);
    String advertise = config.get(ServerConfig.ADVERTISE);
    if (!fleet) {
      if (config.get(ServerConfig.DURABILITY) != ServerConfig.Durability.ASYNC) {
        return "--durability needs --fleet";
      }
      return config.get(ServerConfig.FLEET_KEY) != null
          ? "--fleet-key needs --fleet"
          : advertise != null
              ? "--advertise needs --fleet"
              : config.get(ServerConfig.PLAY_ADVERTISE) != null
                  ? "--play-advertise needs --fleet"
                  : null;
    }
    if (config.get(ServerConfig.FLEET_KEY) == null) {
      return "--fleet needs --fleet-key FILE, the same key on every server of the fleet";
    }
    if (advertise == null && !hasAddress) {
      return "--fleet needs --advertise HOST, by which players and other servers reach this server";
    }
    if (advertise != null && !isAddress(advertise)) {
      return "--advertise="
          + advertise
          + " must be HOST, HOST:TCP or HOST:TCP:UDP, such as a.example.org:54555";
    }
    if (config.get(ServerConfig.SCENE) != null) {
      return "--scene and --fleet exclude each other: nobody plays in a scene";
    }
    return null;
  }

  private static boolean isAddress(String text) {
    var parts = ADDRESS.matcher(text);
    return parts.matches()
        && Sockets.isReachable(parts.group(2))
        && Sockets.isReachable(parts.group(3));
  }

  /** Returns the host of {@code --advertise}, as people write it. */
  public static String host(String advertise) {
    var parts = ADDRESS.matcher(advertise);
    return parts.matches() ? parts.group(1) : advertise;
  }

  /**
   * Returns the address for players, as clients read it.
   *
   * @param tcpPort the server's, where {@code --advertise} names none
   */
  static String address(String advertise, int tcpPort) {
    var parts = ADDRESS.matcher(advertise);
    if (!parts.matches() || parts.group(2) == null) {
      return host(advertise) + ":" + tcpPort;
    }
    String udp = parts.group(3) == null ? "" : "/" + parts.group(3);
    return host(advertise) + ":" + parts.group(2) + udp;
  }
}
