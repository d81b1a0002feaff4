package carom.server.command;

import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.room.Room;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.IntFunction;

/**
 * Writes the rooms' counters for an operator: one line for each room, and one for all rooms
 * together if there are several.
 */
public final class StatusLine {
  private static final double NS_PER_S = 1e9;

  private final List<Room> rooms;
  private final List<Reading> start = new ArrayList<>();
  private final List<Counters.TickReader> tickTimes;
  private List<Reading> last;

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
    for (int i = 0; i < rooms.size(); i++) {
      start.add(new Reading(startNs));
    }
    this.last = start;
    this.tickTimes = rooms.stream().map(room -> room.counters().tickReader()).toList();
  }

  /** Returns the lines for the time since the last call of this method. */
  public synchronized List<String> next(long nowNs) {
    List<Reading> from = last;
    last = read(nowNs);
    return lines(from, last, i -> tickTimes.get(i).take());
  }

  /** Returns the lines for the whole time since the start. Doesn't affect {@link #next}. */
  public synchronized List<String> sinceStart(long nowNs) {
    return lines(start, read(nowNs), i -> rooms.get(i).counters().total());
  }

  private List<Reading> read(long nowNs) {
    return rooms.stream().map(room -> Reading.of(room.counters(), nowNs)).toList();
  }

  private List<String> lines(
      List<Reading> from, List<Reading> to, IntFunction<Counters.TickTimes> times) {
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < rooms.size(); i++) {
      Room room = rooms.get(i);
      Counters.TickTimes took = times.apply(i);
      String label = rooms.size() == 1 ? "" : "room " + room.name() + ": ";
      lines.add(
          label.isEmpty() || !room.hasFailed()
              ? label + line(room, new Span(from.get(i), to.get(i)), took)
              : label + "failed at tick " + room.tick());
    }
    if (rooms.size() > 1) {
      Span all = new Span(Reading.sum(from), Reading.sum(to));
      int places = rooms.stream().mapToInt(room -> room.seats().count()).sum();
      lines.add(
          String.format(
              Locale.ROOT, "all %d rooms: %s, %s", rooms.size(), all.players(places), all.load()));
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
