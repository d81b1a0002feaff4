package carom.server;

import carom.server.fleet.FleetService;
import carom.server.room.Room;
import carom.server.web.Health;
import java.util.HashSet;
import java.util.Set;

/** A server as Agones is told about it: in a fleet, or alone. Any thread. */
final class PodServer implements AgonesSubject {
  private final Server server;
  private final FleetService fleet; // or null
  private final Health health;

  /**
   * Creates a view of a server.
   *
   * @param fleet the server's part in its fleet, or null if it is alone
   */
  PodServer(Server server, FleetService fleet) {
    this.server = server;
    this.fleet = fleet;
    health = new Health(server.rooms(), System::nanoTime);
  }

  @Override
  public String problem() {
    return health.problem();
  }

  @Override
  public Set<String> players() {
    Set<String> names = new HashSet<>();
    server.rooms().forEach(room -> names.addAll(room.seats().names()));
    return names;
  }

  @Override
  public int roomsInUse() {
    int used = 0;
    for (Room room : server.rooms()) {
      used += room.seats().takenCount() > 0 ? 1 : 0;
    }
    return used;
  }

  @Override
  public void drain() {
    if (fleet != null) {
      fleet.member().drain();
    }
  }

  @Override
  public boolean isDraining() {
    return fleet != null && fleet.member().isDraining();
  }

  @Override
  public boolean isDrained() {
    return fleet == null || fleet.member().isDrained();
  }
}
