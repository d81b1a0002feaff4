package carom.server;

import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.room.Room;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;

/**
 * Writes the rooms' counters for an operator: one line for each room, and one for all rooms
 * together if there are several.
 */
final class StatusLine {
  private static final double NS_PER_S = 1e9;

  private final List<Room> rooms;
  private final long startNs;
  private final Map<Room, Counters.TickReader> tickTimes = new HashMap<>();
  private Map<Room, Reading> last = Map.of();

  /** The values of all counters at one moment. */
  private static final class Reading {
    private final long timeNs;
    private final long[] values = new long[Counter.values().length];

    Reading(long timeNs) {
      this.timeNs = timeNs;
    }

    static Reading of(Counters counters, long timeNs) {
      Reading reading = new Reading(timeNs);
      for (Counter counter : Counter.values()) {
        reading.values[counter.ordinal()] = counters.get(counter);
      }
      return reading;
    }

    static Reading sum(List<Reading> parts) {
      Reading sum = new Reading(parts.get(0).timeNs);
      for (Reading part : parts) {
        Arrays.setAll(sum.values, i -> sum.values[i] + part.values[i]);
      }
      return sum;
    }

    long get(Counter counter) {
      return values[counter.ordinal()];
    }
  }

  /** The time between two readings. */
  private record Span(Reading from, Reading to) {
    long grew(Counter counter) {
      return to.get(counter) - from.get(counter);
    }

    double perSecond(Counter counter) {
      return grew(counter) / Math.max(1e-9, (to.timeNs - from.timeNs) / NS_PER_S);
    }

    String players(int places) {
      long waiting = to.get(Counter.PLAYERS_IN_GRACE);
      return to.get(Counter.PLAYERS)
          + (" of " + places + " players")
          + (waiting == 0 ? "" : " and " + waiting + " expected back");
    }

    String load() {
      long postponed = grew(Counter.SNAPSHOTS_POSTPONED);
      return String.format(
              Locale.ROOT,
              "late %d, dropped %d, in %.1f kbit/s, out %.1f kbit/s in %.0f datagrams/s,"
                  + " inputs missing %.2f %%",
              grew(Counter.TICKS_LATE),
              grew(Counter.TICKS_DROPPED),
              perSecond(Counter.BYTES_IN) * 8 / 1e3,
              perSecond(Counter.SNAPSHOT_BYTES) * 8 / 1e3,
              perSecond(Counter.DATAGRAMS_OUT),
              100.0 * grew(Counter.INPUTS_MISSING) / Math.max(1, grew(Counter.INPUTS_DUE)))
          + (postponed == 0 ? "" : ", " + postponed + " snapshots a tick later");
    }
  }

  /**
   * Begins to count.
   *
   * @param startNs monotonic time
   */
  public StatusLine(List<Room> rooms, long startNs) {
    this.rooms = rooms;
    this.startNs = startNs;
    last = read(startNs);
  }

  /**
   * Returns the lines for the time since the last call of this method. Rooms that were paused all
   * the time have none.
   */
  public synchronized List<String> next(long nowNs) {
    Map<Room, Reading> from = last;
    last = read(nowNs);
    tickTimes.keySet().retainAll(last.keySet());
    return lines(from, last, room -> tickTimes.get(room).take(), true);
  }

  /** Returns the lines for the whole time since the start. Doesn't affect {@link #next}. */
  public synchronized List<String> sinceStart(long nowNs) {
    return lines(Map.of(), read(nowNs), room -> room.counters().total(), false);
  }

  /** Reads the counters of the present rooms, in their order. */
  private Map<Room, Reading> read(long nowNs) {
    Map<Room, Reading> readings = new LinkedHashMap<>();
    for (Room room : rooms) {
      tickTimes.computeIfAbsent(room, added -> added.counters().tickReader());
      readings.put(room, Reading.of(room.counters(), nowNs));
    }
    return readings;
  }

  private List<String> lines(
      Map<Room, Reading> known,
      Map<Room, Reading> to,
      Function<Room, Counters.TickTimes> times,
      boolean quiet) {
    List<String> lines = new ArrayList<>();
    List<Reading> from = new ArrayList<>();
    for (Map.Entry<Room, Reading> now : to.entrySet()) {
      Room room = now.getKey();
      Reading before = known.getOrDefault(room, new Reading(startNs));
      from.add(before);
      Counters.TickTimes took = times.apply(room);
      Span span = new Span(before, now.getValue());
      if (quiet && room.isPaused() && span.grew(Counter.TICKS) == 0) {
        continue;
      }
      String label = to.size() == 1 && !room.isNamed() ? "" : "room " + room.name() + ": ";
      lines.add(
          label.isEmpty() || !room.hasFailed()
              ? label + line(room, span, took)
              : label + "failed at tick " + room.tick());
    }
    if (to.size() > 1 && !lines.isEmpty()) {
      Span all = new Span(Reading.sum(from), Reading.sum(List.copyOf(to.values())));
      int places = to.keySet().stream().mapToInt(room -> room.seats().count()).sum();
      lines.add(
          String.format(
              Locale.ROOT, "all %d rooms: %s, %s", to.size(), all.players(places), all.load()));
    }
    return lines;
  }

  private String line(Room room, Span span, Counters.TickTimes times) {
    return String.format(
        Locale.ROOT,
        "%s, tick %d, %.1f Hz, %s, %s",
        span.players(room.seats().count()),
        room.tick(),
        span.perSecond(Counter.TICKS),
        times,
        span.load());
  }
}
