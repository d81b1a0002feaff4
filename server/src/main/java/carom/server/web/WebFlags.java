package carom.server.web;

import carom.options.Sockets;
import carom.server.access.AddressRange;
import carom.server.access.Secret;
import carom.server.command.CommandRegistry;
import carom.server.config.DataFolder;
import carom.server.config.EffectiveSettings;
import carom.server.config.ServerConfig;
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

/** The server's flags about HTTP: the live page, health and metrics. */
public final class WebFlags {
  private WebFlags() {}

  /** Returns what is wrong with the flags, or null. */
  public static String problem(ServerConfig config) {
    return Sockets.first(
        Sockets.addressProblem("--web-bind", config.get(ServerConfig.WEB_BIND)),
        proxyProblem(config));
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
  public static WebServer open(
      ServerConfig config,
      WebSubject subject,
      DataFolder data,
      List<Path> recordings,
      EffectiveSettings settings,
      CommandRegistry commands,
      LogTail tail)
      throws IOException {
    // Not a constant: this class is loaded while the log starts.
    Logger log = LoggerFactory.getLogger(WebFlags.class);
    if (!config.get(ServerConfig.WEB)) {
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
    InetAddress address = InetAddress.getByName(config.get(ServerConfig.WEB_BIND));
    PageConfig page =
        new PageConfig(
            subject.name() + " " + subject.version(),
            commands,
            token,
            subject.logins().page(),
            tail,
            recordings,
            address.isLoopbackAddress(),
            proxies(config),
            hosts(config));
    try {
      WebServer server =
          new WebServer(
              address, config.get(ServerConfig.WEB_PORT), subject, new LivePage(page, subject));
      log.info(
          "page: {} ({})",
          server.url(),
          kept ? "admin token in " + file : "admin token until the stop: " + token.text());
      return server;
    } catch (IOException e) {
      if (settings.isSet(ServerConfig.WEB_PORT)) {
        throw e;
      }
      log.warn("no page, /healthz and /metrics: {}", e.getMessage());
      return null;
    }
  }

  private static String proxyProblem(ServerConfig config) {
    return config.get(ServerConfig.WEB_BEHIND).stream()
        .filter(network -> AddressRange.parse(network).isEmpty())
        .findFirst()
        .map(network -> "--web-behind: " + AddressRange.problem(network))
        .orElse(null);
  }

  private static List<AddressRange> proxies(ServerConfig config) {
    return config.get(ServerConfig.WEB_BEHIND).stream()
        .map(network -> AddressRange.parse(network).orElseThrow())
        .toList();
  }

  private static Set<String> hosts(ServerConfig config) {
    return config.get(ServerConfig.WEB_HOST).stream()
        .map(host -> host.toLowerCase(Locale.ROOT))
        .collect(Collectors.toUnmodifiableSet());
  }
}
