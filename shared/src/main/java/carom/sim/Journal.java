package carom.sim;

/**
 * Hears everything that enters a simulation and is not computed by it: who comes and goes, and what
 * each player does in a tick. Level, seed, tick rate and a journal of this are enough to compute
 * every state again, bit for bit; {@code carom.replay} writes one to a file.
 *
 * <p>{@link Simulation} itself tells, so that nobody who drives it can forget to. Who changes its
 * world from outside of {@link Game} and of these calls leaves the journal. On the simulation's
 * thread; must change nothing.
 */
public interface Journal {
  /** A player is about to come in, before {@link Game#join}. */
  void joining(Simulation s, int id, String name);

  /** A player is about to go, before {@link Game#leave}. */
  void leaving(Simulation s, int id);

  /**
   * A step is about to begin: {@link Player#input} and {@link Player#viewDelay} of every player are
   * what it will read; {@link Simulation#tick} is the tick before.
   */
  void stepping(Simulation s);

  /** The step has ended; not called when it threw. */
  void stepped(Simulation s);
}
