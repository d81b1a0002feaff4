package carom.client.link;

import carom.net.protocol.ServerMessage;
import carom.net.protocol.ServerMessage.RoomEntry;
import java.util.ArrayList;
import java.util.List;

/** Puts the messages that list a server's rooms together. One thread. */
public final class RoomListing {
  private static final int MAX_ROOMS = 1_024;

  private List<RoomEntry> arriving = new ArrayList<>();

  /** Creates a listing of which nothing has arrived. */
  public RoomListing() {}

  /** Takes the next message; returns all rooms when it is the last of a list, else null. */
  public List<RoomEntry> add(ServerMessage.RoomList message) {
    arriving.addAll(message.rooms());
    if (message.left() > 0 && arriving.size() < MAX_ROOMS) {
      return null;
    }
    List<RoomEntry> complete = List.copyOf(arriving);
    arriving = new ArrayList<>();
    return complete;
  }
}
