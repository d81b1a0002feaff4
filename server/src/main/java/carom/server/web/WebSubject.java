package carom.server.web;

import carom.net.transport.NetworkCounter;
import carom.server.access.Logins;
import carom.server.fleet.FleetFigures;
import carom.server.metrics.Figure;
import carom.server.room.Room;
import java.util.List;

/**
 * The server that the page and the metrics tell about. Immutable.
 *
 * @param name the server's name
 * @param version the build's version
 * @param rooms all rooms
 * @param network what the transport counts
 * @param logins where operators log in
 * @param fleet the fleet as the server sees it, or null if it is alone
 * @param figures further numbers for the metrics
 */
public record WebSubject(
    String name,
    String version,
    List<Room> rooms,
    List<NetworkCounter> network,
    Logins logins,
    FleetFigures fleet,
    List<Figure> figures) {
  /** Copies the lists. */
  public WebSubject {
    network = List.copyOf(network);
    figures = List.copyOf(figures);
  }
}
