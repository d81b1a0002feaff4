package carom.lab.fleet;

import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/**
 * Measures what a large fleet asks of its directory, in virtual time: with rooms that rest, with
 * players who come and go, after the death of a server, and when one is drained. Fails if a room
 * has two owners at a time, or none in the end.
 */
@Command(
    name = "fleet",
    mixinStandardHelpOptions = true,
    description = "Measures the directory's traffic of a large fleet of toy rooms.")
public final class FleetSoak implements Callable<Integer> {
  private static final double SETTLE_S = 5;
  private static final double LOOK_S = 0.1;
  private static final double MOST_S = 60;

  @Option(names = "--servers", paramLabel = "N", description = "default ${DEFAULT-VALUE}")
  private int servers = 20;

  @Option(names = "--rooms", paramLabel = "N", description = "in all, default ${DEFAULT-VALUE}")
  private int rooms = 10_000;

  @Option(names = "--places", paramLabel = "N", description = "of a room, ${DEFAULT-VALUE}")
  private int places = 12;

  @Option(names = "--players", paramLabel = "N", description = "in all, default ${DEFAULT-VALUE}")
  private int players = 100_000;

  @Option(
      names = "--stay",
      paramLabel = "S",
      description = "how long a player stays on average, s, default ${DEFAULT-VALUE}")
  private double stayS = 600;

  @Option(
      names = "--seconds",
      paramLabel = "S",
      description = "virtual time of each part that is measured, default ${DEFAULT-VALUE}")
  private double seconds = 20;

  @Option(names = "--seed", paramLabel = "N", description = "default ${DEFAULT-VALUE}")
  private long seed = 1;

  private long turns;
  private double turnS;

  @Override
  public Integer call() throws Exception {
    System.out.printf(
        "fleet: servers=%d rooms=%d places=%d players=%d stay=%.0f s seed=%d%n",
        servers, rooms, places, players, stayS, seed);
    System.out.println(
        "part       s   calls/s of a server: renewals  claims updates  others    kB/s"
            + "   events/s told  kB/s told   updates/s of a room   turns/s  ms each");
    try (ToyFleet fleet = new ToyFleet(servers, rooms, places, seed)) {
      tell("begin", 0, fleet, fleet.traffic());
      fleet.run(SETTLE_S);
      measure("rest", fleet);
      fleet.populate(players, stayS);
      fleet.run(SETTLE_S);
      measure("play", fleet);
      System.out.printf(
          Locale.ROOT,
          "players=%d came=%d to another server=%d no place=%d%n",
          fleet.players(),
          fleet.joins(),
          fleet.moves(),
          fleet.refused());
      int lost = fleet.rooms(0);
      DirectoryTraffic before = fleet.traffic();
      fleet.kill(0);
      double goneS = until(fleet, () -> fleet.owned() == rooms);
      tell("death", goneS, fleet, fleet.traffic().since(before));
      System.out.printf(Locale.ROOT, "death: rooms=%d have owners after %.1f s%n", lost, goneS);
      double followedS = until(fleet, () -> fleet.followed() == rooms);
      System.out.printf(Locale.ROOT, "death: all have followers after %.1f s more%n", followedS);
      int given = fleet.rooms(1);
      before = fleet.traffic();
      fleet.drain(1);
      double drainS = until(fleet, () -> fleet.rooms(1) == 0 && fleet.owned() == rooms);
      tell("drain", drainS, fleet, fleet.traffic().since(before));
      System.out.printf(Locale.ROOT, "drain: rooms=%d moved in %.1f s%n", given, drainS);
      System.out.printf("most owners of a room at a time: %d%n", fleet.mostOwners());
      return fleet.mostOwners() == 1 && fleet.owned() == rooms ? 0 : 1;
    }
  }

  private interface Condition {
    boolean holds();
  }

  /** Lets time pass until something is so, and returns how much, s. */
  private static double until(ToyFleet fleet, Condition condition) {
    double waited = 0;
    while (!condition.holds() && waited < MOST_S) {
      fleet.run(LOOK_S);
      waited += LOOK_S;
    }
    return waited;
  }

  private void measure(String part, ToyFleet fleet) {
    DirectoryTraffic before = fleet.traffic();
    fleet.run(seconds);
    tell(part, seconds, fleet, fleet.traffic().since(before));
  }

  private void tell(String part, double lengthS, ToyFleet fleet, DirectoryTraffic t) {
    double of = servers * Math.max(1, lengthS);
    System.out.printf(
        Locale.ROOT,
        "%-7s %5.1f  %8.1f             %8.1f %7.1f %7.1f %7.1f %7.1f  %14.1f %10.1f  %20.4f  %8.1f"
            + " %8.2f%n",
        part,
        lengthS,
        t.calls() / of,
        t.renewals() / of,
        t.claims() / of,
        t.updates() / of,
        t.others() / of,
        t.bytes() / of / 1e3,
        t.events() / of,
        t.eventBytes() / of / 1e3,
        t.updates() / Math.max(1, lengthS) / rooms,
        (fleet.turns() - turns) / of,
        1e3 * (fleet.turnS() - turnS) / Math.max(1, fleet.turns() - turns));
    turns = fleet.turns();
    turnS = fleet.turnS();
  }
}
