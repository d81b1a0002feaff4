package carom.server.fleet;

import java.util.Collection;
import java.util.Map;
import java.util.TreeMap;

/**
 * Chooses rooms that a busy server gives to one that has less to do. A move costs players a moment,
 * so only a server that is half busy gives rooms away, only if the difference is large and lasts,
 * one room at a time, and only one that makes the difference clearly smaller. So rooms come to
 * rest, also where several servers choose the same one at once. One thread.
 */
final class Balance {
  /** Load below which a server keeps its rooms, percent of its processors. */
  static final int BUSY_PERCENT = 50;

  /** Load of a server that can do no more, percent. */
  static final int FULL_PERCENT = 100;

  /** Least difference of load to another server, percent. */
  static final int LEAST_DIFFERENCE = 20;

  /** Least that a move must take off the difference, percent. */
  static final int LEAST_GAIN = 5;

  /** Time for which the difference must have lasted, ns. */
  static final long STABLE_NS = 10_000_000_000L;

  /** Time after a move until the next: loads are means, and told a moment later, ns. */
  static final long REST_NS = 20_000_000_000L;

  private static final long NEVER = Long.MIN_VALUE;

  private long unevenNs = NEVER;
  private long movedNs = NEVER;

  /** A room, and the server to which it should go. */
  record Move(String room, ServerRecord to) {}

  /**
   * Returns the room that should move now, or null.
   *
   * @param rooms of this server, each with its load, percent of this server's processors; where a
   *     server can't keep up, the sum may be above 100, and counts as 100
   * @param others the servers that can take rooms
   * @param nowNs monotonic
   */
  Move next(Map<String, Double> rooms, Collection<ServerRecord> others, long nowNs) {
    double sum = rooms.values().stream().mapToDouble(load -> load).sum();
    double own = Math.min(FULL_PERCENT, sum);
    ServerRecord to = null;
    for (ServerRecord other : others) {
      boolean less = to == null || other.load() < to.load();
      to = less || (other.load() == to.load() && other.lease() < to.lease()) ? other : to;
    }
    if (to == null || own < BUSY_PERCENT || own - to.load() < LEAST_DIFFERENCE) {
      unevenNs = NEVER;
      return null;
    }
    unevenNs = unevenNs == NEVER ? nowNs : unevenNs;
    boolean rests = movedNs != NEVER && nowNs - movedNs < REST_NS;
    if (rests || nowNs - unevenNs < STABLE_NS) {
      return null;
    }
    double difference = own - to.load();
    String best = null;
    double most = 0;
    for (Map.Entry<String, Double> room : new TreeMap<>(rooms).entrySet()) {
      double load = room.getValue() * (own / sum);
      double gain = difference - Math.abs(difference - 2 * load);
      if (gain >= LEAST_GAIN && gain > most) {
        best = room.getKey();
        most = gain;
      }
    }
    if (best == null) {
      return null;
    }
    movedNs = nowNs;
    unevenNs = NEVER;
    return new Move(best, to);
  }
}
