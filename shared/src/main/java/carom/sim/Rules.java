package carom.sim;

import carom.sim.entity.Entity;
import carom.sim.entity.Player;
import carom.sim.field.FieldHolder;
import java.util.function.Consumer;

/**
 * A simulation as {@link Game#rules} sees it, on the server and on each client that predicts. A
 * client has all of the match's fields that players are told, and of the entities those near its
 * player. So a rule must follow from these:
 *
 * <ul>
 *   <li>the tick, the level, and fields that all players near are told;
 *   <li>{@link #countInside} and {@link #playersInside}, which count what a client doesn't have,
 *       too;
 *   <li>one entity, its fields and what it touched in the last step. Who looks at all {@link
 *       #entities} treats each by itself.
 * </ul>
 *
 * <p>It may write fields that all players near are told, {@linkplain #move move} kinematic bodies
 * of the level, {@link Entity#despawn} what belongs to nobody, and emit events. Everything else is
 * refused: there is no spawn, no push and no random number. A client that computes a tick again
 * takes all of it back. Where it lacks what the rule read, the server's word follows.
 */
public interface Rules extends Simulation, FieldHolder<Entity, Player> {
  /**
   * Returns the entities in the order of their ids, without the level's static geometry; on a
   * client those that it predicts. What is despawned meanwhile is left out.
   */
  Iterable<Entity> entities();

  /**
   * Returns how many solid dynamic bodies were in a sensor in the last step. Server and clients
   * return the same number, also where a client doesn't have the bodies. One in two sensors of this
   * name counts twice.
   *
   * @param sensor the name of {@code statics} of the level with {@code "sensor": true}
   * @throws IllegalArgumentException if the level has none of that name
   */
  int countInside(String sensor);

  /** Returns how many of {@link #countInside} belong to players. */
  int playersInside(String sensor);

  /**
   * Visits the bodies that were in a sensor in the last step; on a client those that it predicts.
   *
   * @param sensor as of {@link #countInside}
   * @param visitor may write fields of what it visits; it must not despawn it
   */
  void forEachInside(String sensor, Consumer<Entity> visitor);

  /**
   * Begins to move a kinematic body of the level to a place, at constant speed, from the next tick
   * on. It replaces a move that goes on. Call it once, when something changes.
   *
   * @param body the name of one of {@code bodies} of the level, kinematic and without a motion
   * @param x where its origin goes, m, -32768..32768
   * @param y where its origin goes, m, -32768..32768
   * @param seconds until it is there, 0..3600, a tick at least; above 500 m/s it takes longer
   * @throws IllegalArgumentException if a number is outside its range, if the level has no such
   *     body, or several of that name, or if it is beyond the first {@value
   *     carom.sim.level.LevelTrigger#MAX_MOVED} such bodies
   */
  void move(String body, float x, float y, float seconds);
}
