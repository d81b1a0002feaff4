package carom.server;

import carom.server.command.CommandRegistry;
import carom.server.config.Settings;
import carom.server.console.LogTail;
import carom.server.login.Secret;
import carom.server.web.WebServer;
import carom.server.web.page.LivePage;
import carom.server.web.page.PageConfig;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import org.slf4j.Logger;

/** Opens the port for HTTP: the live page, health and metrics. */
final class WebStart {
  private final ServerFlags flags;
  private final Settings settings;
  private final Logger log;

  WebStart(ServerFlags flags, Settings settings, Logger log) {
    this.flags = flags;
    this.settings = settings;
    this.log = log;
  }

  /**
   * Opens the port, or returns null if the operator doesn't want one. A server whose usual port is
   * busy, perhaps by another server, runs without it.
   *
   * @param commands carried out for those who know the token
   * @param title name and version of the server
   * @throws StartFailure if the port was named and can't be opened, or the token's file can't be
   *     used; the server is closed then
   */
  WebServer open(Server server, CommandRegistry commands, LogTail tail, String title)
      throws StartFailure {
    if (!flags.web) {
      return null;
    }
    Path tokenFile = flags.dataFolder().adminToken();
    Secret token;
    boolean kept = true;
    try {
      token = Secret.of(tokenFile);
    } catch (IOException e) {
      if (Files.exists(tokenFile)) {
        server.close();
        throw new StartFailure(e.getMessage(), e);
      }
      token = Secret.random();
      kept = false;
    }
    PageConfig config =
        new PageConfig(
            title,
            commands,
            token,
            tail,
            recordings(),
            flags.webAddress().isLoopbackAddress(),
            hosts());
    try {
      WebServer web =
          new WebServer(
              flags.webAddress(),
              flags.webPort,
              server.rooms(),
              server.networkCounters(),
              new LivePage(config, server.rooms()));
      log.info(
          "page: {} ({})",
          web.url(),
          kept ? "admin token in " + tokenFile : "admin token until the stop: " + token.text());
      return web;
    } catch (IOException e) {
      if (settings.find("web-port").orElseThrow().isSet()) {
        server.close();
        throw new StartFailure(e.getMessage(), e);
      }
      log.warn("no page, /healthz and /metrics: {}", e.getMessage());
      return null;
    }
  }

  private List<Path> recordings() {
    List<Path> folders = new ArrayList<>();
    folders.add(flags.dataFolder().recordings());
    if (flags.record != null && Files.isDirectory(flags.record)) {
      folders.add(flags.record);
    }
    return folders;
  }

  private Set<String> hosts() {
    return flags.webHosts.stream()
        .map(host -> host.toLowerCase(Locale.ROOT))
        .collect(Collectors.toUnmodifiableSet());
  }
}
