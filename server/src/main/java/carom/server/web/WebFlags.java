package carom.server.web;

import carom.options.Sockets;
import carom.server.command.CommandRegistry;
import carom.server.config.DataFolder;
import carom.server.config.EffectiveSettings;
import carom.server.console.LogTail;
import carom.server.login.Secret;
import carom.server.web.page.LivePage;
import carom.server.web.page.PageConfig;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
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
          "Address of this machine for HTTP. On a loopback address any visitor may watch, on"
              + " another only visitors that know the token in admin.token of the data folder"
              + " (${DEFAULT-VALUE}).")
  private String webBind;

  @Option(
      names = "--web-host",
      paramLabel = "NAME",
      description =
          "Name under which browsers may open the page, beside addresses and localhost; give it"
              + " once for each name.")
  private List<String> webHosts = List.of();

  /** Creates flags that picocli has yet to fill in. */
  public WebFlags() {}

  /** Returns what is wrong with the flags, or null. */
  public String problem() {
    return Sockets.first(
        Sockets.portProblem("--web-port", webPort), Sockets.addressProblem("--web-bind", webBind));
  }

  /**
   * Opens the port, or returns null if the operator doesn't want one. A server whose usual port is
   * busy, perhaps by another server, runs without it.
   *
   * @param subject the server
   * @param data has the page's token, and recordings
   * @param record target of the flag {@code --record}, or null
   * @param settings tell whether the port was named
   * @param commands carried out for those who know the token
   * @param tail the log's last lines
   * @throws IOException if the port was named and can't be opened, or the token's file can't be
   *     used; the message says what to do
   */
  public WebServer open(
      WebSubject subject,
      DataFolder data,
      Path record,
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
            recordings(data, record),
            address.isLoopbackAddress(),
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

  private static List<Path> recordings(DataFolder data, Path record) {
    List<Path> folders = new ArrayList<>();
    folders.add(data.recordings());
    if (record != null && Files.isDirectory(record)) {
      folders.add(record);
    }
    return folders;
  }

  private Set<String> hosts() {
    return webHosts.stream()
        .map(host -> host.toLowerCase(Locale.ROOT))
        .collect(Collectors.toUnmodifiableSet());
  }
}
