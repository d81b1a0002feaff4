package carom.server.query;

import carom.options.Sockets;
import carom.server.access.LoginThrottle;
import carom.server.access.Secret;
import carom.server.command.CommandRegistry;
import carom.server.config.DataFolder;
import carom.server.config.EffectiveSettings;
import java.io.IOException;
import java.net.InetAddress;
import java.util.Collections;
import java.util.List;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import picocli.CommandLine.Option;

/** The server's flags about standard protocols. Picocli fills them in. */
public final class ProtocolFlags {
  @Option(
      names = "--query",
      paramLabel = "true|false",
      arity = "0..1",
      negatable = true,
      fallbackValue = "true",
      defaultValue = "true",
      description = "Answer A2S status queries of server lists and local networks (UDP).")
  private boolean query;

  @Option(
      names = "--query-port",
      paramLabel = "N",
      defaultValue = "27015",
      description = "Port for status queries, 0..65535, 0 = any free one (${DEFAULT-VALUE}).")
  private int queryPort;

  @Option(
      names = "--rcon",
      paramLabel = "true|false",
      arity = "0..1",
      negatable = true,
      fallbackValue = "true",
      defaultValue = "false",
      description =
          "Take commands by Source RCON (TCP, not encrypted); the password is in rcon.password of"
              + " the data folder.")
  private boolean rcon;

  @Option(
      names = "--rcon-port",
      paramLabel = "N",
      defaultValue = "27015",
      description = "Port for RCON, 0..65535, 0 = any free one (${DEFAULT-VALUE}).")
  private int rconPort;

  @Option(
      names = "--rcon-bind",
      paramLabel = "ADDRESS",
      defaultValue = "127.0.0.1",
      description = "Address of this machine for RCON (${DEFAULT-VALUE}).")
  private String rconBind;

  /** Creates flags that picocli has yet to fill in. */
  public ProtocolFlags() {}

  /** Returns what is wrong with the flags, or null. */
  public String problem() {
    return Sockets.first(
        Sockets.portProblem("--query-port", queryPort),
        Sockets.portProblem("--rcon-port", rconPort),
        Sockets.addressProblem("--rcon-bind", rconBind));
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
  public void open(
      List<InetAddress> addresses,
      DataFolder data,
      EffectiveSettings settings,
      CommandRegistry commands,
      StatusFacts facts,
      LoginThrottle throttle)
      throws IOException {
    // Not a constant: this class is loaded while the log starts.
    Logger log = LoggerFactory.getLogger(ProtocolFlags.class);
    if (rcon) {
      Secret password = Secret.of(data.rconPassword());
      InetAddress rconAddress = InetAddress.getByName(rconBind);
      int port = new RemoteConsole(rconAddress, rconPort, commands, password, throttle).port();
      log.info("rcon: tcp {}, password in {}", port, data.rconPassword());
    }
    if (query) {
      try {
        List<InetAddress> all = addresses.isEmpty() ? Collections.singletonList(null) : addresses;
        for (InetAddress address : all) {
          log.info("status queries: udp {}", new StatusQuery(address, queryPort, facts).port());
        }
      } catch (IOException e) {
        if (settings.find("query-port").orElseThrow().isSet()) {
          throw e;
        }
        log.warn("no status queries: {}", e.getMessage());
      }
    }
  }
}
