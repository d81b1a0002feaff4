package carom.server.http;

import io.undertow.server.HttpServerExchange;
import io.undertow.util.Headers;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * Refuses requests that a browser makes for a foreign page.
 *
 * <ul>
 *   <li><b>Host.</b> A foreign site can have its own name resolve to this machine, and then counts
 *       as the same origin (DNS rebinding). It can't do so with an address or {@code localhost}, so
 *       these are welcome, and other names only if the operator lists them.
 *   <li><b>Origin.</b> Any site may open a WebSocket to this machine, and its browser says which
 *       site that was. Only the page itself may.
 * </ul>
 */
public final class RequestGuard {
  private static final Pattern IPV4 = Pattern.compile("\\d{1,3}(\\.\\d{1,3}){3}");
  private static final Pattern IPV6 = Pattern.compile("\\[[0-9a-f:.]+\\]");

  private final Set<String> hosts;

  /**
   * Creates a guard.
   *
   * @param hosts names that are welcome beside addresses and {@code localhost}, in lower case
   */
  public RequestGuard(Set<String> hosts) {
    this.hosts = hosts;
  }

  /** Returns whether a request's Host is one of this server. */
  public boolean acceptsHost(HttpServerExchange exchange) {
    return acceptsHost(exchange.getRequestHeaders().getFirst(Headers.HOST));
  }

  /** Returns whether a request comes from the page itself. */
  public boolean acceptsOrigin(HttpServerExchange exchange) {
    return acceptsOrigin(
        exchange.getRequestHeaders().getFirst(Headers.ORIGIN),
        exchange.getRequestHeaders().getFirst(Headers.HOST));
  }

  /**
   * Returns whether a request comes from no page at all, from one of this server, or from one of a
   * host that is welcome by name. Programs that are no browsers say no origin.
   */
  public boolean acceptsPage(HttpServerExchange exchange) {
    String origin = exchange.getRequestHeaders().getFirst(Headers.ORIGIN);
    return origin == null
        || (acceptsOrigin(exchange) && acceptsHost(exchange))
        || hosts.contains(hostOf(origin));
  }

  private static String hostOf(String origin) {
    return withoutPort(origin.replaceFirst("^[a-z]+://", ""));
  }

  private static String withoutPort(String host) {
    return host.toLowerCase(Locale.ROOT).replaceFirst(":\\d{1,5}$", "");
  }

  boolean acceptsHost(String header) {
    if (header == null) {
      return false;
    }
    String host = withoutPort(header);
    return host.equals("localhost")
        || IPV4.matcher(host).matches()
        || IPV6.matcher(host).matches()
        || hosts.contains(host);
  }

  static boolean acceptsOrigin(String origin, String host) {
    return origin != null
        && host != null
        && (origin.equalsIgnoreCase("http://" + host)
            || origin.equalsIgnoreCase("https://" + host));
  }
}
