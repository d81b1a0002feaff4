package carom.server.query;

import carom.server.room.Room;
import java.util.List;
import java.util.function.Supplier;

/**
 * The facts that a status query tells about a server.
 *
 * @param named returns the server's name
 * @param version version of the program
 * @param tcpPort port by which players join
 * @param udpPort port of their datagrams
 * @param rooms all rooms, a live list
 */
public record StatusFacts(
    Supplier<String> named, String version, int tcpPort, int udpPort, List<Room> rooms) {
  /** Creates the facts of a server whose name doesn't change. */
  public StatusFacts(String name, String version, int tcpPort, int udpPort, List<Room> rooms) {
    this(() -> name, version, tcpPort, udpPort, rooms);
  }

  /** Returns the server's name. */
  public String name() {
    return named.get();
  }
}
