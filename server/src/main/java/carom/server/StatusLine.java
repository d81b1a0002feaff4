package carom.server;

import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.room.Room;
import java.util.Locale;

/** The room's counters in one line that an operator can read. */
final class StatusLine {
  private static final double NS_PER_S = 1e9;

  private final Room room;
  private final Counters counters;
  private final ServerConfig config;
  private final long startNs;
  private Reading last;

  /** Values at one moment. */
  private record Reading(
      long timeNs,
      long ticks,
      long late,
      long dropped,
      long bytesIn,
      long bytesOut,
      long datagramsIn,
      long datagramsOut,
      long missing) {
    static Reading of(Counters c, long timeNs) {
      return new Reading(
          timeNs,
          c.get(Counter.TICKS),
          c.get(Counter.TICKS_LATE),
          c.get(Counter.TICKS_DROPPED),
          c.get(Counter.BYTES_IN),
          c.get(Counter.SNAPSHOT_BYTES),
          c.get(Counter.DATAGRAMS_IN),
          c.get(Counter.DATAGRAMS_OUT),
          c.get(Counter.INPUTS_MISSING));
    }

    static Reading zero(long timeNs) {
      return new Reading(timeNs, 0, 0, 0, 0, 0, 0, 0, 0);
    }
  }

  StatusLine(Room room, ServerConfig config, long startNs) {
    this.room = room;
    this.counters = room.counters();
    this.config = config;
    this.startNs = startNs;
    this.last = Reading.zero(startNs);
  }

  /** About the time since this method was last called. */
  synchronized String next(long nowNs) {
    Reading now = Reading.of(counters, nowNs);
    String line = line(last, now, counters.takeInterval());
    last = now;
    return line;
  }

  /** About the whole time since the start; changes nothing. */
  synchronized String sinceStart(long nowNs) {
    return line(Reading.zero(startNs), Reading.of(counters, nowNs), counters.total());
  }

  private String line(Reading from, Reading to, Counters.TickTimes times) {
    double seconds = Math.max(1e-9, (to.timeNs - from.timeNs) / NS_PER_S);
    long inputsDue = Math.max(1, to.datagramsIn - from.datagramsIn);
    return String.format(
        Locale.ROOT,
        "%d of %d players%s, tick %d, %.1f Hz, %s, late %d, dropped %d,"
            + " in %.1f kbit/s, out %.1f kbit/s in %.0f datagrams/s, inputs missing %.2f %%",
        counters.get(Counter.PLAYERS),
        config.maxPlayers(),
        grace(),
        room.tick(),
        (to.ticks - from.ticks) / seconds,
        times,
        to.late - from.late,
        to.dropped - from.dropped,
        (to.bytesIn - from.bytesIn) * 8 / 1e3 / seconds,
        (to.bytesOut - from.bytesOut) * 8 / 1e3 / seconds,
        (to.datagramsOut - from.datagramsOut) / seconds,
        100.0 * (to.missing - from.missing) / inputsDue);
  }

  private String grace() {
    long waiting = counters.get(Counter.PLAYERS_IN_GRACE);
    return waiting == 0 ? "" : " and " + waiting + " expected back";
  }
}
