package carom.lab.soak;

import carom.net.transport.Impairment;
import carom.physics.math.SimRandom;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Something that happens to a server or a client.
 *
 * @param atS moment since the soak began, s of virtual time
 * @param client number of the client that it happens to; incidents of the server ignore it
 * @param detail decides what the kind leaves open
 */
record Incident(double atS, Kind kind, int client, long detail) {
  /** The kinds of incidents. The number says how often one happens, relative to the others. */
  enum Kind {
    /** The client connects, unless it is there already. */
    JOIN(30),
    /** The player closes the window. */
    LEAVE(6),
    /** The client's process dies. */
    DIE(3),
    /** The connection breaks, and the client comes back. */
    CUT(4),
    /** The client's line is dead for up to twenty seconds. */
    BLACKOUT(3),
    /** The client's process stands still for up to three seconds. */
    FREEZE(3),
    /** The client's network gets better or worse. */
    NETWORK(12),
    /** The player talks. */
    TALK(6),
    /** The player shows an emote. */
    EMOTE(3),
    /** The player goes to another room. */
    MOVE(4),
    /** The room of the client goes on to its next level. */
    LEVEL(3),
    /** The server's process stands still for up to two seconds. */
    STALL(1),
    /** The server is stopped and started again; every other time its world begins anew. */
    RESTART(1),
    /** The server's process is killed, and another one goes on from its checkpoints. */
    CRASH(1);

    private final int weight;

    Kind(int weight) {
      this.weight = weight;
    }
  }

  private static final double MEAN_GAP_S = 0.8;

  /** Returns all that happens in a soak. Equal seeds give equal lists, and longer soaks go on. */
  static List<Incident> script(long seed, double seconds, int clients) {
    SimRandom random = new SimRandom(seed);
    int weights = 0;
    for (Kind kind : Kind.values()) {
      weights += kind.weight;
    }
    List<Incident> script = new ArrayList<>();
    double at = 0;
    while (true) {
      at += 2 * MEAN_GAP_S * random.nextFloat();
      if (at >= seconds) {
        return script;
      }
      int draw = random.nextInt(weights);
      int kind = 0;
      for (; draw >= Kind.values()[kind].weight; kind++) {
        draw -= Kind.values()[kind].weight;
      }
      script.add(
          new Incident(
              at, Kind.values()[kind], random.nextInt(clients), random.nextInt(Integer.MAX_VALUE)));
    }
  }

  /** Returns the network that the detail stands for: from a perfect one to a bad mobile one. */
  Impairment network() {
    return switch ((int) (detail % 5)) {
      case 0 -> Impairment.NONE;
      case 1 -> Impairment.NONE.withLatency(20, 5);
      case 2 -> Impairment.NONE.withLatency(60, 10).withLoss(2);
      case 3 -> Impairment.NONE.withLatency(100, 30).withLoss(5).withReorder(5, 2);
      default -> Impairment.NONE.withLatency(150, 40).withBursts(8, 3).withReorder(10, 5);
    };
  }

  @Override
  public String toString() {
    return String.format(Locale.ROOT, "%.2f s: %s client=%d detail=%d", atS, kind, client, detail);
  }
}
