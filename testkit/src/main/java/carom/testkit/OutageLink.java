package carom.testkit;

import carom.net.protocol.ProtocolLimits;
import carom.net.transport.Link;
import carom.net.transport.LinkCounters;
import carom.net.transport.LinkHandler;
import java.util.ArrayDeque;
import java.util.function.Supplier;

/** A link over the line of an {@link OutageTransport}. */
final class OutageLink implements Link {
  private static final int ALL = 1_024;

  private final Supplier<Link> connect;
  private final ArrayDeque<Object> toSend = new ArrayDeque<>();
  private final ArrayDeque<Object> arrived = new ArrayDeque<>();
  private final LinkCounters noCounters = new LinkCounters();

  /** Null until the line has been alive. */
  private Link link;

  private boolean dead;

  /** The state when the line ended, which its owner goes on to see. */
  private State frozen = State.CONNECTING;

  /** Why this end closed the link, or null. */
  private String closedHere;

  /** Why the other end closed it, if that was heard while the line was dead, or null. */
  private String closedThere;

  private boolean closeReported;

  /** Takes what reaches this end of a dead line: messages are kept, datagrams are lost. */
  private final LinkHandler keeper =
      new LinkHandler() {
        @Override
        public void message(Link from, Object message) {
          arrived.add(message);
        }

        @Override
        public void datagram(Link from, byte[] bytes, int length) {}

        @Override
        public void closed(Link from, String reason) {
          closedThere = reason;
        }
      };

  OutageLink(Supplier<Link> connect, boolean dead) {
    this.connect = connect;
    this.dead = dead;
    if (!dead) {
      link = connect.get();
    }
  }

  // ---- the line

  void lineEnds() {
    if (!dead) {
      frozen = state();
      dead = true;
    }
  }

  void lineReturns() {
    if (!dead) {
      return;
    }
    if (link != null) {
      keepArrivals();
    } else if (closedHere == null) {
      link = connect.get();
    }
    dead = false;
    if (link != null) {
      toSend.forEach(link::send);
      if (closedHere != null) {
        link.close(closedHere);
      }
    }
    toSend.clear();
  }

  private void keepArrivals() {
    while (link.poll(keeper, ALL) == ALL) {
      // until nothing is left
    }
  }

  /** Returns whether nothing that happens to the line matters to the link. */
  boolean isOver() {
    return !dead && state() == State.CLOSED;
  }

  // ---- the link

  @Override
  public State state() {
    if (closedHere != null) {
      return State.CLOSED;
    }
    return dead ? frozen : link.state();
  }

  @Override
  public boolean send(Object message) {
    if (!dead) {
      return link.send(message);
    }
    return state() == State.OPEN && toSend.add(message);
  }

  @Override
  public boolean sendDatagram(byte[] bytes, int offset, int length) {
    if (!dead) {
      return link.sendDatagram(bytes, offset, length);
    }
    if (length < 1 || length > ProtocolLimits.MAX_DATAGRAM_BYTES) {
      throw new IllegalArgumentException(
          "datagram length=" + length + " is outside 1.." + ProtocolLimits.MAX_DATAGRAM_BYTES);
    }
    return state() == State.OPEN;
  }

  @Override
  public int poll(LinkHandler handler, int max) {
    if (dead && closedHere == null) {
      if (link != null) {
        keepArrivals();
      }
      return 0;
    }
    int count = 0;
    for (; count < max && !arrived.isEmpty(); count++) {
      handler.message(this, arrived.remove());
    }
    if (closedHere != null || closedThere != null) {
      if (!closeReported && arrived.isEmpty()) {
        closeReported = true;
        handler.closed(this, closeReason());
      }
      return count;
    }
    return count + link.poll(handler, max - count);
  }

  @Override
  public long waitedNs() {
    return link == null ? 0 : link.waitedNs();
  }

  @Override
  public void close(String reason) {
    if (closedHere != null) {
      return; // perhaps there never was a link: the line was dead when this one was made
    }
    if (!dead) {
      link.close(reason);
    } else if (state() != State.CLOSED) {
      closedHere = reason;
    }
  }

  @Override
  public String remote() {
    return link == null ? "not connected" : link.remote();
  }

  @Override
  public String closeReason() {
    if (closedHere != null) {
      return closedHere;
    }
    if (closedThere != null) {
      return dead ? "" : closedThere;
    }
    return link == null || dead ? "" : link.closeReason();
  }

  @Override
  public LinkCounters counters() {
    return link == null ? noCounters : link.counters();
  }
}
