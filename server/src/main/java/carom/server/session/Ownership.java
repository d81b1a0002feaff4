package carom.server.session;

import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BooleanSupplier;

/**
 * Says whether a room's server owns it now. In a fleet, a room belongs to one server at a time, by
 * a claim in the fleet's directory, and only while the server's lease there holds. A room that
 * isn't owned stands still, and nothing that it sends leaves the process: it may go on elsewhere.
 * The room of a server without a fleet is always owned.
 *
 * <p>Any thread; the fleet's thread changes it.
 */
public final class Ownership {
  private final BooleanSupplier lease; // null without a fleet
  private volatile long before;
  private volatile long claim;

  /** The news of the fleet for clients, by their doors; empty without one. */
  private final Map<Link.Door, ServerMessage.Fleet> servers = new ConcurrentHashMap<>();

  private Ownership(BooleanSupplier lease) {
    this.lease = lease;
  }

  /** Returns the ownership of a room whose server has no fleet. */
  public static Ownership alone() {
    return new Ownership(null);
  }

  /**
   * Returns the ownership of a room that has no claim yet.
   *
   * @param lease whether the server's lease holds now; asked before each datagram, any thread
   */
  public static Ownership under(BooleanSupplier lease) {
    return new Ownership(lease);
  }

  /** Returns whether the room may tick and send now. */
  public boolean holds() {
    return lease == null || (claim > 0 && lease.getAsBoolean());
  }

  /** Returns the number of the claim; 0 for none and without a fleet. */
  public long claim() {
    return claim;
  }

  /**
   * Returns whether what this server has kept of the room under a claim is the room's latest state:
   * nobody has owned it since.
   */
  public boolean isLatest(long keptUnder) {
    return lease == null || keptUnder == before || keptUnder == claim;
  }

  /** Sets the number of the claim, 0 for none. */
  public void claim(long number) {
    claim = number;
  }

  /**
   * Sets the number of the claim.
   *
   * @param last number of the room's last claim before this one, 0 for none
   */
  public void claim(long number, long last) {
    before = last;
    claim = number;
  }

  /** Returns what clients of a door are told of the fleet, or null. */
  public ServerMessage.Fleet servers(Link.Door door) {
    return servers.get(door);
  }

  /** Sets what clients of a door are told of the fleet. */
  public void servers(Link.Door door, ServerMessage.Fleet message) {
    servers.put(door, message);
  }

  /** Returns a link that sends for the room only while it is owned. */
  public Link guard(Link link) {
    return lease == null ? link : link.sendingWhile(this::holds);
  }
}
