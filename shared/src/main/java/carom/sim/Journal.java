package carom.sim;

import carom.sim.entity.Newcomer;
import carom.sim.message.PlayerRole;

/**
 * Receives everything that enters a simulation and is not computed by it: players who join, leave
 * and change their role, their messages and their inputs. Level, seed, tick rate and a journal are
 * enough to compute every state again, bit for bit. {@code carom.replay} writes one to a file. A
 * journal that only follows the steps leaves out the rest.
 *
 * <p>{@link SimulationHost} itself calls it, so that no caller can forget to. A caller that changes
 * the world outside of {@link Game} and of these calls makes the journal incomplete. All methods
 * run on the simulation's thread and must change nothing.
 */
public interface Journal {
  /** Receives a player who is about to join, before {@link Game#join}. */
  default void joining(SimulationHost s, int id, Newcomer newcomer) {}

  /** Receives a spectator who is about to come. */
  default void watching(SimulationHost s, int id, Newcomer newcomer) {}

  /**
   * Receives a participant who is about to change its role, before {@link Game#join} or {@link
   * Game#leave}, unless the game or a message changes it.
   */
  default void changing(SimulationHost s, int id, PlayerRole role) {}

  /** Receives a participant who is about to get back what an account has kept. */
  default void keeping(SimulationHost s, int id, int[] values) {}

  /** Receives a participant who is about to leave, before {@link Game#leave}. */
  default void leaving(SimulationHost s, int id) {}

  /**
   * Receives the simulation before a step. The step will handle the messages that {@link
   * SimulationHost#forEachReceived} passes on, and read {@link HostPlayer#input} and {@link
   * HostPlayer#viewDelay} of every participant as they are now. {@link SimulationHost#tick} is the
   * tick before.
   */
  void stepping(SimulationHost s);

  /** Receives the simulation after a step, unless the step threw. */
  void stepped(SimulationHost s);
}
