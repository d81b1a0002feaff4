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

  /** Most moves within a fleet that a client follows within {@link #PERIOD_NS}. */
  static final int MOST_MOVES = 30;

  static final long PERIOD_NS = 60_000_000_000L;

  /** Addresses of this machine, of its network, and of no single machine, as people write them. */
  private static final Pattern LOCAL =
      Pattern.compile(
          "(?i)[^.:]+|.*\\.(local|localhost|internal|lan)|0\\w*\\..*|"
              + "(10|127|169\\.254|192\\.168|172\\.(1[6-9]|2\\d|3[01])|22[4-9]|2[3-5]\\d)\\..*|"
              + "::.*|f[cdf][\\da-f]{2}:.*|fe[89ab][\\da-f]:.*");

  private final ArrayDeque<Long> followedNs = new ArrayDeque<>();
  private final ArrayDeque<Long> movedNs = new ArrayDeque<>();

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
    count(followedNs, MOST, to, nowNs);
    return to;
  }

  /**
   * Returns where a move within a fleet leads, if the client should follow. A server with the key
   * of the one that sent the move is the same to the client, wherever it is.
   *
   * @param server address of the other server
   * @param sameKey whether that server must show the key that this one has proven
   * @param from the server that sent it
   * @param nowNs monotonic time
   * @throws IllegalArgumentException in words for the player, when it should not
   */
  public ServerAddress followMove(String server, boolean sameKey, ServerAddress from, long nowNs) {
    if (!sameKey) {
      return follow(new ServerMessage.Redirect(server, "", "", ""), from, nowNs);
    }
    ServerAddress to = ServerAddress.parse(server);
    count(movedNs, MOST_MOVES, to, nowNs);
    return to;
  }

  private static void count(ArrayDeque<Long> pastNs, int most, ServerAddress to, long nowNs) {
    while (!pastNs.isEmpty() && nowNs - pastNs.peek() > PERIOD_NS) {
      pastNs.remove();
    }
    if (pastNs.size() == most) {
      throw new IllegalArgumentException(
          "Servers sent you on " + (most + 1) + " times within a minute, last to " + to + ".");
    }
    pastNs.add(nowNs);
  }

  /** Returns whether a host is written as one of this machine or network. */
  static boolean isLocal(String host) {
    return LOCAL.matcher(host).matches();
  }
}
