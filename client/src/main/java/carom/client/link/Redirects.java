package carom.client.link;

import carom.net.protocol.ServerMessage;
import java.util.ArrayDeque;
import java.util.regex.Pattern;

/**
 * Decides whether a client follows a server that sends it to another one: not in circles, not from
 * the internet into the player's own network, and nothing of the session goes along. One thread at
 * a time.
 */
public final class Redirects {
  /** Most redirects that a client follows within {@link #PERIOD_NS}. */
  static final int MOST = 3;

  static final long PERIOD_NS = 60_000_000_000L;

  /** Addresses of this machine, of its network, and of no single machine, as people write them. */
  private static final Pattern LOCAL =
      Pattern.compile(
          "(?i)[^.:]+|.*\\.(local|localhost|internal|lan)|0\\w*\\..*|"
              + "(10|127|169\\.254|192\\.168|172\\.(1[6-9]|2\\d|3[01])|22[4-9]|2[3-5]\\d)\\..*|"
              + "::.*|f[cdf][\\da-f]{2}:.*|fe[89ab][\\da-f]:.*");

  private final ArrayDeque<Long> followedNs = new ArrayDeque<>();

  /** Creates an object that has followed none. */
  public Redirects() {}

  /**
   * Returns where a redirect leads, if the client should follow.
   *
   * @param from the server that sent it
   * @param nowNs monotonic time
   * @return address of the other server
   * @throws IllegalArgumentException in words for the player, when it should not
   */
  public ServerAddress follow(ServerMessage.Redirect redirect, ServerAddress from, long nowNs) {
    ServerAddress to;
    try {
      to = ServerAddress.parse(redirect.server());
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(
          from + " sent you to \"" + redirect.server() + "\", which is no server's address.", e);
    }
    if (to.toString().equalsIgnoreCase(from.toString())) {
      throw new IllegalArgumentException(from + " sent you to itself.");
    }
    if (isLocal(to.host()) && !isLocal(from.host())) {
      throw new IllegalArgumentException(
          from
              + " sent you to "
              + to
              + ", which is in your own network. Enter that address yourself if you mean it.");
    }
    while (!followedNs.isEmpty() && nowNs - followedNs.peek() > PERIOD_NS) {
      followedNs.remove();
    }
    if (followedNs.size() == MOST) {
      throw new IllegalArgumentException(
          "Servers sent you on " + (MOST + 1) + " times within a minute, last to " + to + ".");
    }
    followedNs.add(nowNs);
    return to;
  }

  /** Returns whether a host is written as one of this machine or network. */
  static boolean isLocal(String host) {
    return LOCAL.matcher(host).matches();
  }
}
