package carom.server;

import carom.server.config.ServerConfig;
import java.util.Map;

/** The settings that concern Agones, and what Agones itself sets in the environment. */
final class AgonesFlags {
  /** Variable with the port of the sidecar, which Agones sets in each of its pods. */
  public static final String PORT = "AGONES_SDK_HTTP_PORT";

  /** The port that the sidecar has if nobody chose another. */
  private static final int USUAL_PORT = 9_358;

  private static final int LAST_PORT = 65_535;

  private AgonesFlags() {}

  /**
   * Returns whether the server tells a sidecar how it is.
   *
   * @param environment of the process
   */
  public static boolean isOn(ServerConfig config, Map<String, String> environment) {
    return switch (config.get(ServerConfig.AGONES)) {
      case ON -> true;
      case OFF -> false;
      case AUTO -> environment.containsKey(PORT);
    };
  }

  /** Returns why Agones can't be used, or null. */
  public static String problem(ServerConfig config, Map<String, String> environment) {
    return isOn(config, environment) && port(environment) == 0
        ? PORT + "=" + environment.get(PORT) + " must be a port; or don't use it: --agones off"
        : null;
  }

  /** Returns the sidecar's port, 0 if what the environment has is none. */
  public static int port(Map<String, String> environment) {
    String text = environment.get(PORT);
    if (text == null) {
      return USUAL_PORT;
    }
    int port = text.matches("\\d{1,5}") ? Integer.parseInt(text) : 0;
    return port <= LAST_PORT ? port : 0;
  }
}
