package carom.client.link;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.ServerMessage.RoomEntry;
import carom.net.transport.ClientTransport;
import carom.net.transport.Link;
import java.util.List;

/** Asks a server once for its rooms. */
public final class RoomBrowser extends ServerQuestion {
  private static final long ANSWER_NS = 10_000_000_000L;

  private final RoomListing listing = new RoomListing();
  private long askedNs;
  private long roundTripNs;
  private List<RoomEntry> rooms = List.of();

  /**
   * Creates a browser that asks at the first {@link #update}.
   *
   * @param transport opens the link; stays the caller's
   */
  public RoomBrowser(ServerAddress address, ClientTransport transport) {
    super(address, transport, ANSWER_NS);
  }

  @Override
  protected void ask(Link open) {
    askedNs = nowNs();
    open.send(new ClientMessage.ListRooms(Protocol.VERSION));
  }

  @Override
  protected boolean answered(Object message) {
    if (!(message instanceof ServerMessage.RoomList list)) {
      return false;
    }
    if (roundTripNs == 0) {
      roundTripNs = Math.max(1, nowNs() - askedNs);
    }
    List<RoomEntry> all = listing.add(list);
    if (all != null) {
      rooms = all;
      end("");
    }
    return true;
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
    return outcome();
  }
}
