package carom.server.match;

import carom.physics.threads.Workers;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counters;
import carom.server.session.Ownership;
import carom.server.session.Seats;
import carom.sim.SimulationHost;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;

/**
 * The context that the parts of a room share. The room's thread, but for {@link #match} and what
 * never changes.
 */
public final class RoomContext {
  private final Supplier<ServerConfig> config;
  private final String label;
  private final Counters counters;
  private final Seats seats;
  private final Ownership ownership;
  private Workers workers;
  private volatile Match match;
  private final AtomicInteger age = new AtomicInteger();

  /**
   * Creates the context of a room that begins with a match.
   *
   * @param config returns the present settings of the server
   * @param label begins each log line: the room's name, or empty if there is only one room
   * @param ownership whether the server owns the room
   */
  public RoomContext(
      Supplier<ServerConfig> config,
      String label,
      Counters counters,
      Seats seats,
      Ownership ownership,
      Match match) {
    this.config = config;
    this.label = label;
    this.counters = counters;
    this.seats = seats;
    this.ownership = ownership;
    this.match = match;
  }

  /** Returns the present settings of the server; from any thread. */
  public ServerConfig config() {
    return config.get();
  }

  /** Returns how each log line begins; from any thread. */
  public String label() {
    return label;
  }

  /** Returns what the room counts; from any thread. */
  public Counters counters() {
    return counters;
  }

  /** Returns the seats, shared with the lobby; from any thread. */
  public Seats seats() {
    return seats;
  }

  /** Returns whether the server owns the room; from any thread. */
  public Ownership ownership() {
    return ownership;
  }

  /** Returns the present match; from any thread. */
  public Match match() {
    return match;
  }

  /** Returns the simulation of the present match. */
  public SimulationHost simulation() {
    return match.simulation();
  }

  /** Goes on with another match. */
  public void play(Match next) {
    next.simulation().world().workers(workers);
    match = next;
  }

  /** Lets other threads help with stepping the worlds; null for none. */
  public void helpedBy(Workers helpers) {
    workers = helpers;
    match.simulation().world().workers(helpers);
  }

  /** Notes that a tick has passed. */
  public void passTick() {
    age.getAndIncrement();
  }

  /** Returns the number of ticks of all matches of the room; from any thread. */
  public int age() {
    return age.get();
  }
}
