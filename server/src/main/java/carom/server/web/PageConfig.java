package carom.server.web;

import carom.server.access.AddressRange;
import carom.server.access.LoginThrottle;
import carom.server.access.Secret;
import carom.server.command.CommandRegistry;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;

/**
 * The server behind the live page, as the page knows it. Immutable.
 *
 * @param title name and version of the server
 * @param commands carried out for those who know the secret
 * @param secret what they must know
 * @param throttle limits wrong secrets
 * @param log the log's last lines
 * @param recordings folders of recordings
 * @param strangersWatch whether rooms and charts are shown to visitors at this machine without the
 *     secret
 * @param proxies addresses of proxies, which tell from where their requests come
 * @param hosts names under which browsers may reach the server, beside addresses and {@code
 *     localhost}
 */
record PageConfig(
    String title,
    CommandRegistry commands,
    Secret secret,
    LoginThrottle throttle,
    LogTail log,
    List<Path> recordings,
    boolean strangersWatch,
    List<AddressRange> proxies,
    Set<String> hosts) {
  /** Copies the lists. */
  public PageConfig {
    recordings = List.copyOf(recordings);
    proxies = List.copyOf(proxies);
    hosts = Set.copyOf(hosts);
  }
}
