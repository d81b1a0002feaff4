package carom.server.thin.web;

import carom.options.Sockets;
import carom.server.access.AddressRange;
import carom.server.config.ServerConfig;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The flags of the play port: the door to thin clients of every language and browser. */
public final class PlayFlags {
  private static final Pattern ADDRESS = Pattern.compile("(?:" + Sockets.HOST + "):(\\d{1,5})");

  private PlayFlags() {}

  /** Returns what is wrong with the flags, or null. */
  public static String problem(ServerConfig config) {
    Integer playPort = config.get(ServerConfig.PLAY_PORT);
    Path tlsCert = config.get(ServerConfig.TLS_CERT);
    Path tlsKey = config.get(ServerConfig.TLS_KEY);
    String advertise = config.get(ServerConfig.PLAY_ADVERTISE);
    return Sockets.first(
        (tlsCert == null) == (tlsKey == null)
            ? null
            : (tlsCert == null ? "--tls-key needs --tls-cert" : "--tls-cert needs --tls-key"),
        playPort == null && tlsCert != null ? "--tls-cert needs --play-port" : null,
        playPort == null && advertise != null ? "--play-advertise needs --play-port" : null,
        advertise != null && !isAddress(advertise)
            ? "--play-advertise=" + advertise + " must be HOST:PORT, such as a.example.org:443"
            : null,
        config.get(ServerConfig.PLAY_BEHIND).stream()
            .filter(network -> AddressRange.parse(network).isEmpty())
            .findFirst()
            .map(network -> "--play-behind: " + AddressRange.problem(network))
            .orElse(null));
  }

  private static boolean isAddress(String text) {
    Matcher address = ADDRESS.matcher(text);
    return address.matches() && Sockets.isReachable(address.group(1));
  }

  /**
   * Returns the address of an open port as clients are told it, host:port; empty without one, and
   * where a proxy stands before it whose address isn't known.
   *
   * @param host by which players reach this server
   */
  public static String address(ServerConfig config, String host, PlayPort port) {
    String advertised = config.get(ServerConfig.PLAY_ADVERTISE);
    if (port != null && advertised != null) {
      return advertised;
    }
    return port == null || !config.get(ServerConfig.PLAY_BEHIND).isEmpty()
        ? ""
        : host + ":" + port.tcpPort();
  }

  /**
   * Opens the port, or returns null if the operator doesn't want it.
   *
   * @param addresses of this machine on which the server's ports are open; empty for all
   * @param most links in all
   * @param mostPerAddress links of one address, as soon as half of all are taken
   * @throws IOException if the port can't be opened, or the certificates can't be used; the message
   *     says what to do
   */
  public static PlayPort open(
      ServerConfig config, List<InetAddress> addresses, int most, int mostPerAddress)
      throws IOException {
    Integer playPort = config.get(ServerConfig.PLAY_PORT);
    if (playPort == null) {
      return null;
    }
    // Not a constant: this class is loaded while the log starts.
    Logger log = LoggerFactory.getLogger(PlayFlags.class);
    Path tlsCert = config.get(ServerConfig.TLS_CERT);
    Certificates certificates =
        tlsCert == null ? null : Certificates.of(tlsCert, config.get(ServerConfig.TLS_KEY));
    PlayPort port =
        new PlayPort(
            new PlayPort.Settings(
                addresses,
                playPort,
                config.get(ServerConfig.PLAY_HOST).stream()
                    .map(host -> host.toLowerCase(Locale.ROOT))
                    .collect(Collectors.toUnmodifiableSet()),
                config.get(ServerConfig.PLAY_BEHIND).stream()
                    .map(n -> AddressRange.parse(n).orElseThrow())
                    .toList(),
                most,
                mostPerAddress,
                certificates));
    if (certificates == null) {
      log.info("play: {}, not encrypted; encrypt it with --tls-cert, or a proxy", port.url());
    } else {
      log.info("play: {}, encrypted, certificate good until {}", port.url(), certificates.end());
    }
    return port;
  }
}
