package carom.server.http;

import carom.server.access.AddressRange;
import io.undertow.server.HttpServerExchange;
import io.undertow.util.HeaderMap;
import io.undertow.util.HeaderValues;
import io.undertow.util.Headers;
import io.undertow.util.HttpString;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Tells from where requests come: from the other end of their connection or, if that is one of the
 * operator's proxies, from where the proxy says in {@code X-Forwarded-For}. Each proxy adds the
 * address that it got a request from at the end, so the last one that is no proxy's own counts.
 * What stands before it, visitors can write themselves. Immutable.
 */
public final class Origins {
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
  public record Origin(InetAddress address, boolean isHere) {}

  /**
   * Creates the rule.
   *
   * @param proxies addresses of the operator's proxies
   */
  public Origins(List<AddressRange> proxies) {
    this.proxies = List.copyOf(proxies);
  }

  /** Returns whether an address is that of a proxy. */
  public boolean isProxy(InetAddress address) {
    return proxies.stream().anyMatch(range -> range.contains(address.getAddress()));
  }

  /** Returns whether a proxy that isn't configured handed on a request. */
  public boolean isByUnknownProxy(HttpServerExchange exchange) {
    return !isProxy(exchange.getSourceAddress().getAddress())
        && TRACES.stream().anyMatch(exchange.getRequestHeaders()::contains);
  }

  /** Returns whether one of the operator's proxies says that it got a request encrypted. */
  public boolean isEncryptedByProxy(HttpServerExchange exchange) {
    return isProxy(exchange.getSourceAddress().getAddress())
        && "https".equals(exchange.getRequestHeaders().getFirst(Headers.X_FORWARDED_PROTO));
  }

  /** Returns where a request comes from. */
  public Origin of(HttpServerExchange exchange) {
    HeaderMap headers = exchange.getRequestHeaders();
    HeaderValues forwarded = headers.get(Headers.X_FORWARDED_FOR);
    return from(
        exchange.getSourceAddress().getAddress(),
        forwarded == null ? List.of() : forwarded,
        TRACES.stream().anyMatch(headers::contains));
  }

  /**
   * Returns where a request comes from.
   *
   * @param peer the other end of its connection
   * @param forwarded the lines of {@code X-Forwarded-For}
   * @param traced whether any header is of a proxy
   */
  Origin from(InetAddress peer, List<String> forwarded, boolean traced) {
    if (!isProxy(peer)) {
      return new Origin(peer, !traced && peer.isLoopbackAddress());
    }
    InetAddress from = peer;
    List<String> path = forwarded.stream().flatMap(line -> Stream.of(line.split(",", -1))).toList();
    for (int i = path.size() - 1; i >= 0 && isProxy(from); i--) {
      Optional<InetAddress> before = address(path.get(i));
      if (before.isEmpty()) {
        break;
      }
      from = before.get();
    }
    return new Origin(from, false);
  }

  private static Optional<InetAddress> address(String text) {
    return AddressRange.addressIn(text.strip()).flatMap(Origins::ofBytes);
  }

  private static Optional<InetAddress> ofBytes(byte[] address) {
    try {
      return Optional.of(InetAddress.getByAddress(address));
    } catch (UnknownHostException e) {
      throw new IllegalStateException(e); // can't happen with 4 or 16 bytes
    }
  }
}
