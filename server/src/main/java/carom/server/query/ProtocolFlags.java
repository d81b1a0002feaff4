package carom.server.query;

import carom.options.Sockets;
import carom.server.access.LoginThrottle;
import carom.server.access.Secret;
import carom.server.command.CommandRegistry;
import carom.server.config.DataFolder;
import carom.server.config.EffectiveSettings;
import carom.server.config.ServerConfig;
import java.io.IOException;
import java.net.InetAddress;
import java.util.Collections;
import java.util.List;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The server's flags about standard protocols. */
public final class ProtocolFlags {
  private ProtocolFlags() {}

  /** Returns what is wrong with the flags, or null. */
  public static String problem(ServerConfig config) {
    return Sockets.addressProblem("--rcon-bind", config.get(ServerConfig.RCON_BIND));
  }

  /**
   * Opens the ports that the flags ask for. They close with the process. Status queries are done
   * without if their usual port is busy.
   *
   * @param addresses of this machine for status queries, empty for all
   * @param data has the password of RCON
   * @param settings tell whether a port was named
   * @param facts told by status queries
   * @param throttle limits wrong passwords of RCON
   * @throws IOException if RCON's port, or a query port that was named, can't be opened; the
   *     message says what to do
   */
  public static void open(
      ServerConfig config,
      List<InetAddress> addresses,
      DataFolder data,
      EffectiveSettings settings,
      CommandRegistry commands,
      StatusFacts facts,
      LoginThrottle throttle)
      throws IOException {
    // Not a constant: this class is loaded while the log starts.
    Logger log = LoggerFactory.getLogger(ProtocolFlags.class);
    if (config.get(ServerConfig.RCON)) {
      Secret password = Secret.of(data.rconPassword());
      InetAddress rconAddress = InetAddress.getByName(config.get(ServerConfig.RCON_BIND));
      int port =
          new RemoteConsole(
                  rconAddress, config.get(ServerConfig.RCON_PORT), commands, password, throttle)
              .port();
      log.info("rcon: tcp {}, password in {}", port, data.rconPassword());
    }
    if (config.get(ServerConfig.QUERY)) {
      try {
        List<InetAddress> all = addresses.isEmpty() ? Collections.singletonList(null) : addresses;
        for (InetAddress address : all) {
          log.info(
              "status queries: udp {}",
              new StatusQuery(address, config.get(ServerConfig.QUERY_PORT), facts).port());
        }
      } catch (IOException e) {
        if (settings.isSet(ServerConfig.QUERY_PORT)) {
          throw e;
        }
        log.warn("no status queries: {}", e.getMessage());
      }
    }
  }
}
