package carom.server.session;

import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.net.transport.LinkCounters;
import carom.net.transport.LinkHandler;
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
  private final long before;
  private volatile long claim;
  private volatile ServerMessage.Fleet servers; // null without a fleet

  private Ownership(BooleanSupplier lease, long before) {
    this.lease = lease;
    this.before = before;
  }

  /** Returns the ownership of a room whose server has no fleet. */
  public static Ownership alone() {
    return new Ownership(null, 0);
  }

  /**
   * Returns the ownership of a room that has no claim yet.
   *
   * @param lease whether the server's lease holds now; asked before each datagram, any thread
   * @param before number of the last claim of the room before that of this server, 0 for none
   */
  public static Ownership under(BooleanSupplier lease, long before) {
    return new Ownership(lease, before);
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
    return lease == null || keptUnder == before;
  }

  /** Sets the number of the claim, 0 for none. */
  public void claim(long number) {
    claim = number;
  }

  /** Returns what clients are told of the fleet, or null. */
  public ServerMessage.Fleet servers() {
    return servers;
  }

  /** Sets what clients are told of the fleet. */
  public void servers(ServerMessage.Fleet message) {
    servers = message;
  }

  /** Returns a link that sends for the room only while it is owned. */
  public Link guard(Link link) {
    return lease == null ? unguarded(link) : new Guarded(unguarded(link));
  }

  /** Returns the link behind one that {@link #guard} has returned, or the link itself. */
  public static Link unguarded(Link link) {
    return link instanceof Guarded guarded ? guarded.link : link;
  }

  /** A link of a room in a fleet. */
  private final class Guarded implements Link {
    private final Link link;

    // used by the owner's thread
    private LinkHandler served;
    private LinkHandler renamed;

    Guarded(Link link) {
      this.link = link;
    }

    @Override
    public State state() {
      return link.state();
    }

    @Override
    public boolean send(Object message) {
      return holds() && link.send(message);
    }

    @Override
    public boolean sendDatagram(byte[] bytes, int offset, int length) {
      return holds() && link.sendDatagram(bytes, offset, length);
    }

    @Override
    @SuppressWarnings("ReferenceEquality") // the same handler, not an equal one
    public int poll(LinkHandler handler, int max) {
      if (served != handler) {
        served = handler;
        renamed = as(handler);
      }
      return link.poll(renamed, max);
    }

    /** Returns a handler that hears of this link instead of the one behind it. */
    private LinkHandler as(LinkHandler handler) {
      return new LinkHandler() {
        @Override
        public void message(Link from, Object message) {
          handler.message(Guarded.this, message);
        }

        @Override
        public void datagram(Link from, byte[] bytes, int length) {
          handler.datagram(Guarded.this, bytes, length);
        }

        @Override
        public void closed(Link from, String reason) {
          handler.closed(Guarded.this, reason);
        }
      };
    }

    @Override
    public long waitedNs() {
      return link.waitedNs();
    }

    @Override
    public void close(String reason) {
      link.close(reason);
    }

    @Override
    public boolean isOverTcp() {
      return link.isOverTcp();
    }

    @Override
    public boolean mayPass() {
      return link.mayPass();
    }

    @Override
    public boolean isPlainText() {
      return link.isPlainText();
    }

    @Override
    public boolean isMovable() {
      return link.isMovable();
    }

    @Override
    public String remote() {
      return link.remote();
    }

    @Override
    public String closeReason() {
      return link.closeReason();
    }

    @Override
    public LinkCounters counters() {
      return link.counters();
    }
  }
}
