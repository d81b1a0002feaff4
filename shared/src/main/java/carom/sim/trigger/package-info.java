/**
 * Tells which entities are in which sensors: what enters and leaves them in a tick, as the server
 * tells games, and what is inside a sensor of the level, as both roles compute it.
 *
 * <p>Allowed imports: {@code carom.physics..}, {@code carom.sim.entity}, {@code carom.sim.level},
 * {@code carom.sim.finding}, the JDK. Read first: {@link carom.sim.trigger.Triggers}, {@link
 * carom.sim.trigger.LevelSensors}.
 */
package carom.sim.trigger;
