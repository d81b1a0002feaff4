package carom.client.link;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.protocol.ServerMessage;
import carom.net.transport.ClientTransport;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Knows the fleet of a client's server: where to go when that server is lost, who owns a room, and
 * the <em>standby</em>, a link to the server that follows the client's room. That one speaks first
 * when it goes on with the room. One connection's; one thread.
 */
final class FleetRoute implements LinkHandler {
  /** Time until a standby that was closed or refused is tried again. */
  private static final long RETRY_NS = 2_000_000_000L;

  private final ClientTransport transport;

  /** The servers to try in turn: where the client has been, and what its server has told. */
  private final List<ServerAddress> servers = new ArrayList<>();

  /** The highest claim of each room that the client has seen. */
  private final Map<String, Long> claims = new HashMap<>();

  private ServerAddress standbyAddress; // null for none
  private Link standby; // null while there is none
  private boolean greeted;
  private long retryNs;
  private long nowNs;
  private ServerMessage.Welcome welcome; // over the standby; null before

  /** Creates the route of a client that knows no fleet. */
  FleetRoute(ClientTransport transport) {
    this.transport = transport;
  }

  /** Takes what a server has told of its fleet. */
  void told(ServerMessage.Fleet fleet, ServerAddress present) {
    servers.clear();
    servers.add(present);
    for (String text : fleet.servers()) {
      ServerAddress server = addressOf(text);
      if (server != null && !servers.contains(server)) {
        servers.add(server);
      }
    }
    ServerAddress wanted = fleet.standby().isEmpty() ? null : addressOf(fleet.standby());
    if (wanted == null || !wanted.equals(standbyAddress)) {
      dropStandby();
      standbyAddress = wanted;
      retryNs = nowNs;
    }
  }

  private static ServerAddress addressOf(String text) {
    try {
      return ServerAddress.parse(text);
    } catch (IllegalArgumentException e) {
      return null; // a server that can't be reached is as good as none
    }
  }

  /** Returns the server to try after one that doesn't answer; the same one outside a fleet. */
  ServerAddress after(ServerAddress present) {
    int index = servers.indexOf(present);
    return servers.isEmpty() ? present : servers.get((index + 1) % servers.size());
  }

  /** Returns the number of servers to try, 0 outside a fleet. */
  int count() {
    return servers.size();
  }

  /** Returns whether the follower can speak to the client now. */
  boolean hasStandby() {
    return standby != null && greeted && standby.state() == Link.State.OPEN;
  }

  /** Returns whether a server welcomes the client to a room that another one owns by now. */
  boolean isStale(ServerMessage.Welcome w) {
    return w.claim() < claims.getOrDefault(w.room(), 0L);
  }

  /** Notes who owns a room. */
  void note(ServerMessage.Welcome w) {
    claims.merge(w.room(), w.claim(), Math::max);
  }

  /**
   * Opens the standby, keeps it, and looks whether the follower has spoken.
   *
   * @param secret of the session
   * @param room the session's
   * @return whether it has; then {@link #takeLink} and {@link #takeWelcome} return what came
   */
  boolean poll(long timeNs, long secret, String room) {
    nowNs = timeNs;
    if (standby == null) {
      if (standbyAddress != null && secret != 0 && timeNs - retryNs >= 0) {
        greeted = false;
        standby =
            transport.connect(
                standbyAddress.host(), standbyAddress.tcpPort(), standbyAddress.udpPort());
      }
      return false;
    }
    if (!greeted && standby.state() == Link.State.OPEN) {
      greeted = true;
      standby.send(
          new ClientMessage.Standby(Protocol.VERSION, Protocol.physicsDigest(), secret, room));
    }
    // One by one: what follows Welcome is the connection's to read.
    while (welcome == null && standby != null && standby.poll(this, 1) > 0) {}
    return welcome != null;
  }

  /** Returns the standby, which is the caller's from now on. */
  Link takeLink() {
    Link taken = standby;
    standby = null;
    return taken;
  }

  /** Returns what the follower has said, once. */
  ServerMessage.Welcome takeWelcome() {
    ServerMessage.Welcome taken = welcome;
    welcome = null;
    return taken;
  }

  /** Returns the follower's address. */
  ServerAddress standbyAddress() {
    return standbyAddress;
  }

  /** Forgets the fleet, because a server outside of it has the client now. */
  void forget() {
    leaveStandby();
    servers.clear();
    claims.clear();
  }

  /** Forgets the follower, because the client is at another server. */
  void leaveStandby() {
    dropStandby();
    standbyAddress = null;
  }

  private void dropStandby() {
    welcome = null;
    if (standby != null) {
      Link dropped = standby;
      standby = null;
      dropped.close("the client needs no standby here");
    }
    retryNs = nowNs + RETRY_NS;
  }

  @Override
  public void message(Link from, Object received) {
    if (received instanceof ServerMessage.Welcome w && !isStale(w)) {
      welcome = w;
    } else {
      dropStandby(); // refused, or it doesn't follow the room yet
    }
  }

  @Override
  public void datagram(Link from, byte[] bytes, int length) {
    // Nothing that counts comes before Welcome.
  }

  @Override
  public void closed(Link from, String reason) {
    if (from == standby) {
      dropStandby();
    }
  }
}
