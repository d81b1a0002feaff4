package carom.server.web;

import carom.options.Sockets;
import carom.server.access.AddressRange;
import carom.server.access.Secret;
import carom.server.command.CommandRegistry;
import carom.server.config.DataFolder;
import carom.server.config.EffectiveSettings;
import carom.server.console.LogTail;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import picocli.CommandLine.Option;

/** The server's flags about HTTP: the live page, health and metrics. Picocli fills them in. */
public final class WebFlags {
  @Option(
      names = "--web",
      paramLabel = "true|false",
      arity = "0..1",
      negatable = true,
      fallbackValue = "true",
      defaultValue = "true",
      description =
          "Show the live page and answer /healthz, /readyz and /metrics (Prometheus) over HTTP;"
              + " --no-web doesn't.")
  private boolean web;

  @Option(
      names = "--web-port",
      paramLabel = "N",
      defaultValue = "8090",
      description = "Port for HTTP, 0..65535, 0 = any free one (${DEFAULT-VALUE}).")
  private int webPort;

  @Option(
      names = "--web-bind",
      paramLabel = "ADDRESS",
      defaultValue = "127.0.0.1",
      description =
          "Address of this machine for HTTP. On a loopback address visitors at this machine may"
              + " watch, others only with the token in admin.token of the data folder"
              + " (${DEFAULT-VALUE}).")
  private String webBind;

  @Option(
      names = "--web-host",
      paramLabel = "NAME",
      description =
          "Name under which browsers may open the page, beside addresses and localhost; give it"
              + " once for each name.")
  private List<String> webHosts = List.of();

  @Option(
      names = "--web-behind",
      paramLabel = "NETWORK",
      description =
          "Address or network of a proxy (127.0.0.1, 10.0.0.0/8) before the page: its visitors come"
              + " from where X-Forwarded-For says, and watch with the token only; give it once for"
              + " each.")
  private List<String> webBehind = List.of();

  /** Creates flags that picocli has yet to fill in. */
  public WebFlags() {}

  /** Returns what is wrong with the flags, or null. */
  public String problem() {
    return Sockets.first(
        Sockets.portProblem("--web-port", webPort),
        Sockets.addressProblem("--web-bind", webBind),
        proxyProblem());
  }

  /**
   * Opens the port, or returns null if the operator doesn't want one. A server whose usual port is
   * busy, perhaps by another server, runs without it.
   *
   * @param subject the server
   * @param data has the page's token
   * @param recordings folders of recordings, to be downloaded
   * @param settings tell whether the port was named
   * @param commands carried out for those who know the token
   * @param tail the log's last lines
   * @throws IOException if the port was named and can't be opened, or the token's file can't be
   *     used; the message says what to do
   */
  public WebServer open(
      WebSubject subject,
      DataFolder data,
      List<Path> recordings,
      EffectiveSettings settings,
      CommandRegistry commands,
      LogTail tail)
      throws IOException {
    // Not a constant: this class is loaded while the log starts.
    Logger log = LoggerFactory.getLogger(WebFlags.class);
    if (!web) {
      return null;
    }
    Path file = data.adminToken();
    Secret token;
    boolean kept = true;
    try {
      token = Secret.of(file);
    } catch (IOException e) {
      if (Files.exists(file)) {
        throw e;
      }
      token = Secret.random();
      kept = false;
    }
    InetAddress address = InetAddress.getByName(webBind);
    PageConfig config =
        new PageConfig(
            subject.name() + " " + subject.version(),
            commands,
            token,
            subject.logins().page(),
            tail,
            recordings,
            address.isLoopbackAddress(),
            proxies(),
            hosts());
    try {
      WebServer server =
          new WebServer(address, webPort, subject, new LivePage(config, subject.rooms()));
      log.info(
          "page: {} ({})",
          server.url(),
          kept ? "admin token in " + file : "admin token until the stop: " + token.text());
      return server;
    } catch (IOException e) {
      if (settings.find("web-port").orElseThrow().isSet()) {
        throw e;
      }
      log.warn("no page, /healthz and /metrics: {}", e.getMessage());
      return null;
    }
  }

  private String proxyProblem() {
    return webBehind.stream()
        .filter(network -> AddressRange.parse(network).isEmpty())
        .findFirst()
        .map(network -> "--web-behind: " + AddressRange.problem(network))
        .orElse(null);
  }

  private List<AddressRange> proxies() {
    return webBehind.stream().map(network -> AddressRange.parse(network).orElseThrow()).toList();
  }

  private Set<String> hosts() {
    return webHosts.stream()
        .map(host -> host.toLowerCase(Locale.ROOT))
        .collect(Collectors.toUnmodifiableSet());
  }
}
