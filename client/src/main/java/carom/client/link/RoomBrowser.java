package carom.client.link;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.ServerMessage.RoomEntry;
import carom.net.transport.ClientTransport;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import java.util.List;

/**
 * Asks a server once for its rooms, without joining: opens a link, takes the list and closes the
 * link. It never waits; call {@link #update} until {@link #isDone}. One thread.
 */
public final class RoomBrowser implements LinkHandler, AutoCloseable {
  /** Longest time in which a link opens; links have deadlines of their own for each step. */
  private static final long TIMEOUT_NS = 120_000_000_000L;

  private static final long ANSWER_NS = 10_000_000_000L;

  private final ServerAddress address;
  private final ClientTransport transport;
  private final RoomListing listing = new RoomListing();
  private Link link;
  private boolean asked;
  private boolean done;
  private long startNs;
  private long nowNs;
  private long askedNs;
  private long roundTripNs;
  private List<RoomEntry> rooms = List.of();
  private String problem = "";

  /**
   * Creates a browser that asks at the first {@link #update}.
   *
   * @param transport opens the link; stays the caller's
   */
  public RoomBrowser(ServerAddress address, ClientTransport transport) {
    this.address = address;
    this.transport = transport;
  }

  /** Does what is due. */
  public void update(long timeNs) {
    nowNs = timeNs;
    if (done) {
      return;
    }
    if (link == null) {
      startNs = nowNs;
      link = transport.connect(address.host(), address.tcpPort(), address.udpPort());
    }
    if (!asked && link.state() == Link.State.OPEN) {
      asked = true;
      askedNs = nowNs;
      link.send(new ClientMessage.ListRooms(Protocol.VERSION));
    }
    link.poll(this, 64);
    if (!done && nowNs - (asked ? askedNs : startNs) > (asked ? ANSWER_NS : TIMEOUT_NS)) {
      end("No answer from " + address + ". Check the address; is the server running?");
    }
  }

  private void end(String why) {
    done = true;
    problem = why;
    if (link.state() == Link.State.OPEN) {
      link.send(new ClientMessage.Leave());
    }
    link.close("has asked for the rooms");
  }

  @Override
  public void message(Link from, Object message) {
    if (done) {
      return;
    }
    if (message instanceof ServerMessage.RoomList list) {
      if (roundTripNs == 0) {
        roundTripNs = Math.max(1, nowNs - askedNs);
      }
      List<RoomEntry> all = listing.add(list);
      if (all != null) {
        rooms = all;
        end("");
      }
    } else if (message instanceof ServerMessage.Refused refused) {
      end(refused.playerText());
    } else if (message instanceof ServerMessage.Goodbye goodbye) {
      end(goodbye.playerText());
    } else {
      end(address + " answers something else. Is it a Carom server?");
    }
  }

  @Override
  public void datagram(Link from, byte[] bytes, int length) {
    // The server sends none before a game is joined.
  }

  @Override
  public void closed(Link from, String reason) {
    if (!done) {
      end("Can't reach " + address + ": " + reason);
    }
  }

  /** Returns whether the answer is here, or none will come. */
  public boolean isDone() {
    return done;
  }

  /** Returns the rooms; empty before the answer. */
  public List<RoomEntry> rooms() {
    return rooms;
  }

  /**
   * Returns the time from the question to the answer, nanoseconds, as exact as {@link #update} is
   * often; 0 before it.
   */
  public long roundTripNs() {
    return roundTripNs;
  }

  /** Returns why there is no answer, in words for the player; empty if nothing is wrong. */
  public String problem() {
    return problem;
  }

  @Override
  public void close() {
    if (link != null && !done) {
      end("");
    }
  }
}
