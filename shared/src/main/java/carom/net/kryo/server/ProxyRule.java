package carom.net.kryo.server;

import java.net.InetAddress;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * Proxies in front of the TCP port, which tell by the PROXY protocol, version 2, where a client
 * comes from.
 *
 * @param from whether a connection from an address must begin with that header; from others it
 *     isn't understood
 * @param refused hears, once a minute at most, how many connections were closed and why the last
 */
public record ProxyRule(Predicate<InetAddress> from, Consumer<String> refused) {
  /** No proxies. */
  public static final ProxyRule NONE = new ProxyRule(address -> false, text -> {});
}
