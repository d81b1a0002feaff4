package carom.server.web;

import carom.server.replication.LinkFigures;
import carom.server.room.Picture;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Computes what players' lines and predictions do now, from readings of the last seconds. One
 * thread.
 */
final class PlayerRates {
  private static final int READINGS = 6;
  private static final double NS_PER_S = 1e9;
  private static final double BYTES_PER_KBIT = 125;

  private final ArrayDeque<Reading> readings = new ArrayDeque<>();

  private record Reading(long timeNs, Map<Integer, Picture.Player> players) {}

  /**
   * The present rates of a player's line. NaN for what isn't known.
   *
   * @param player the newest reading
   * @param kbitPerSecond payload of snapshots
   * @param loss share of snapshot datagrams that didn't arrive, 0..1
   * @param right share of ticks in which the client's predictions were right, 0..1
   */
  record Rate(Picture.Player player, double kbitPerSecond, double loss, double right) {}

  /** Adds a reading and returns the rates since the oldest, in the readings' order. */
  List<Rate> add(long timeNs, List<Picture.Player> players) {
    Map<Integer, Picture.Player> byId = new HashMap<>();
    players.forEach(player -> byId.put(player.info().id(), player));
    readings.add(new Reading(timeNs, byId));
    if (readings.size() > READINGS) {
      readings.remove();
    }
    return players.stream().map(player -> rate(timeNs, player)).toList();
  }

  @SuppressWarnings("ReferenceEquality") // Each reading has objects of its own.
  private Rate rate(long timeNs, Picture.Player now) {
    for (Reading reading : readings) {
      Picture.Player then = reading.players().get(now.info().id());
      if (then != null && then != now && isSameLink(then, now)) {
        LinkFigures a = then.link();
        LinkFigures b = now.link();
        double seconds = (timeNs - reading.timeNs()) / NS_PER_S;
        return new Rate(
            now,
            (b.bytesSent() - a.bytesSent()) / BYTES_PER_KBIT / seconds,
            1 - share(b.acked() - a.acked(), b.settled() - a.settled()),
            1
                - share(
                    b.mispredictions() - a.mispredictions(),
                    b.predictedTicks() - a.predictedTicks()));
      }
    }
    return new Rate(now, Double.NaN, Double.NaN, Double.NaN);
  }

  private static boolean isSameLink(Picture.Player then, Picture.Player now) {
    return then.info().name().equals(now.info().name())
        && then.link().bytesSent() <= now.link().bytesSent()
        && then.link().settled() <= now.link().settled();
  }

  private static double share(long part, long whole) {
    return whole <= 0 ? Double.NaN : Math.max(0, Math.min(1, (double) part / whole));
  }
}
