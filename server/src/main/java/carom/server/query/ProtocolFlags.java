package carom.server.query;

import carom.server.command.CommandRegistry;
import carom.server.config.DataFolder;
import carom.server.config.Settings;
import carom.server.login.LoginThrottle;
import carom.server.login.Secret;
import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import picocli.CommandLine.Option;

/** The server's flags about standard protocols. Picocli fills them in. */
public final class ProtocolFlags {
  private static final int MAX_PORT = 65_535;

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
    if (queryPort < 0 || queryPort > MAX_PORT) {
      return "--query-port=" + queryPort + " is outside 0.." + MAX_PORT;
    }
    if (rconPort < 0 || rconPort > MAX_PORT) {
      return "--rcon-port=" + rconPort + " is outside 0.." + MAX_PORT;
    }
    try {
      InetAddress.getByName(rconBind);
      return null;
    } catch (UnknownHostException e) {
      return "--rcon-bind=" + rconBind + " is no address; give one such as 127.0.0.1 or ::1";
    }
  }

  /**
   * Opens the ports that the flags ask for. They close with the process. Status queries are done
   * without if their usual port is busy.
   *
   * @param address address of this machine for status queries, or null for all
   * @param data has the password of RCON
   * @param settings tell whether a port was named
   * @param facts told by status queries
   * @throws IOException if RCON's port, or a query port that was named, can't be opened; the
   *     message says what to do
   */
  public void open(
      InetAddress address,
      DataFolder data,
      Settings settings,
      CommandRegistry commands,
      StatusFacts facts)
      throws IOException {
    // Not a constant: this class is loaded while the log starts.
    Logger log = LoggerFactory.getLogger(ProtocolFlags.class);
    if (rcon) {
      Secret password = Secret.of(data.rconPassword());
      LoginThrottle throttle = new LoginThrottle(System::nanoTime);
      InetAddress rconAddress = InetAddress.getByName(rconBind);
      int port = new RemoteConsole(rconAddress, rconPort, commands, password, throttle).port();
      log.info("rcon: tcp {}, password in {}", port, data.rconPassword());
    }
    if (query) {
      try {
        log.info("status queries: udp {}", new StatusQuery(address, queryPort, facts).port());
      } catch (IOException e) {
        if (settings.find("query-port").orElseThrow().isSet()) {
          throw e;
        }
        log.warn("no status queries: {}", e.getMessage());
      }
    }
  }
}
