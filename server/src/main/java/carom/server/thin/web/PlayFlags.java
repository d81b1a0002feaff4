package carom.server.thin.web;

import carom.options.Sockets;
import carom.server.access.AddressRange;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import picocli.CommandLine.Option;

/** The flags of the play port: the door to thin clients of every language and browser. */
public final class PlayFlags {
  @Option(
      names = "--play-port",
      paramLabel = "N",
      description =
          "Port for HTTP and WebSocket at which browsers play (/play) and thin clients of any"
              + " language (/thin, see docs/protocol/THIN.md), 0..65535, 0 = any free one"
              + " (closed).")
  private Integer playPort;

  @Option(
      names = "--play-host",
      paramLabel = "NAME",
      description =
          "Name under which browsers may reach the play port, beside its addresses and localhost,"
              + " or whose pages may connect to it, such as game.example.org; give it once for"
              + " each.")
  private List<String> playHosts = List.of();

  @Option(
      names = "--play-behind",
      paramLabel = "NETWORK",
      description =
          "Address or network of a proxy (127.0.0.1, 10.0.0.0/8) before the play port: its players"
              + " come from where X-Forwarded-For says; give it once for each.")
  private List<String> playBehind = List.of();

  @Option(
      names = "--tls-cert",
      paramLabel = "FILE",
      description =
          "Encrypt the play port with the certificates in this file: PEM, the server's own first;"
              + " read again when it changes (not encrypted).")
  private Path tlsCert;

  @Option(
      names = "--tls-key",
      paramLabel = "FILE",
      description = "The certificate's private key: PEM, PKCS #8 without a password (none).")
  private Path tlsKey;

  /** Creates flags that picocli has yet to fill in. */
  public PlayFlags() {}

  /** Returns what is wrong with the flags, or null. */
  public String problem() {
    return Sockets.first(
        playPort == null ? null : Sockets.portProblem("--play-port", playPort),
        (tlsCert == null) == (tlsKey == null)
            ? null
            : (tlsCert == null ? "--tls-key needs --tls-cert" : "--tls-cert needs --tls-key"),
        playPort == null && tlsCert != null ? "--tls-cert needs --play-port" : null,
        playBehind.stream()
            .filter(network -> AddressRange.parse(network).isEmpty())
            .findFirst()
            .map(network -> "--play-behind: " + AddressRange.problem(network))
            .orElse(null));
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
  public PlayPort open(List<InetAddress> addresses, int most, int mostPerAddress)
      throws IOException {
    if (playPort == null) {
      return null;
    }
    // Not a constant: this class is loaded while the log starts.
    Logger log = LoggerFactory.getLogger(PlayFlags.class);
    Certificates certificates = tlsCert == null ? null : Certificates.of(tlsCert, tlsKey);
    PlayPort port =
        new PlayPort(
            new PlayPort.Settings(
                addresses,
                playPort,
                playHosts.stream()
                    .map(host -> host.toLowerCase(Locale.ROOT))
                    .collect(Collectors.toUnmodifiableSet()),
                playBehind.stream().map(n -> AddressRange.parse(n).orElseThrow()).toList(),
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
