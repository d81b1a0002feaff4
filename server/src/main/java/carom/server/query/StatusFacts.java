package carom.server.query;

import carom.server.room.Room;
import java.util.List;

/**
 * The facts that a status query tells about a server. Immutable.
 *
 * @param name the server's name
 * @param version version of the program
 * @param tcpPort port by which players join
 * @param udpPort port of their datagrams
 * @param rooms all rooms
 */
public record StatusFacts(String name, String version, int tcpPort, int udpPort, List<Room> rooms) {
  /** Copies the list. */
  public StatusFacts {
    rooms = List.copyOf(rooms);
  }
}
