package carom.server.web.page;

import carom.server.access.AddressRange;
import io.undertow.server.HttpServerExchange;
import io.undertow.util.HeaderMap;
import io.undertow.util.HeaderValues;
import io.undertow.util.Headers;
import io.undertow.util.HttpString;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Tells from where requests come: from the other end of their connection or, if that is one of the
 * operator's proxies, from where the proxy says in {@code X-Forwarded-For}. Each proxy adds the
 * address that it got a request from at the end, so the last one that is no proxy's own counts.
 * What stands before it, visitors can write themselves. Immutable.
 */
final class Origins {
  private static final List<HttpString> TRACES =
      List.of(
          Headers.X_FORWARDED_FOR,
          Headers.X_FORWARDED_PROTO,
          Headers.X_FORWARDED_HOST,
          Headers.FORWARDED,
          Headers.VIA,
          new HttpString("X-Real-IP"));

  private final List<AddressRange> proxies;

  /**
   * The origin of a request.
   *
   * @param address the visitor's address
   * @param isHere whether the visitor sits at this machine for sure: no proxy has had the request
   */
  record Origin(InetAddress address, boolean isHere) {}

  /**
   * Creates the rule.
   *
   * @param proxies addresses of the operator's proxies
   */
  Origins(List<AddressRange> proxies) {
    this.proxies = List.copyOf(proxies);
  }

  /** Returns whether an address is that of a proxy. */
  boolean isProxy(InetAddress address) {
    return proxies.stream().anyMatch(range -> range.contains(address.getAddress()));
  }

  /** Returns where a request comes from. */
  Origin of(HttpServerExchange exchange) {
    return of(exchange.getSourceAddress().getAddress(), exchange.getRequestHeaders());
  }

  Origin of(InetAddress peer, HeaderMap headers) {
    if (!isProxy(peer)) {
      boolean direct = TRACES.stream().noneMatch(headers::contains);
      return new Origin(peer, direct && peer.isLoopbackAddress());
    }
    InetAddress from = peer;
    List<String> path = path(headers);
    for (int i = path.size() - 1; i >= 0 && isProxy(from); i--) {
      Optional<InetAddress> before = address(path.get(i));
      if (before.isEmpty()) {
        break;
      }
      from = before.get();
    }
    return new Origin(from, false);
  }

  private static List<String> path(HeaderMap headers) {
    List<String> path = new ArrayList<>();
    HeaderValues lines = headers.get(Headers.X_FORWARDED_FOR);
    if (lines != null) {
      lines.forEach(line -> path.addAll(List.of(line.split(",", -1))));
    }
    return path;
  }

  private static Optional<InetAddress> address(String text) {
    return AddressRange.addressIn(text.strip()).flatMap(Origins::of);
  }

  private static Optional<InetAddress> of(byte[] address) {
    try {
      return Optional.of(InetAddress.getByAddress(address));
    } catch (UnknownHostException e) {
      throw new IllegalStateException(e); // can't happen with 4 or 16 bytes
    }
  }
}
