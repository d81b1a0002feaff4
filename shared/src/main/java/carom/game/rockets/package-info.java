/**
 * Rockets: players shoot at each other, seen from above. Shows what {@code Game.input} spawns.
 *
 * <p>Allowed imports: {@code carom.sim}, its levels and events, {@code carom.physics..}. The rules
 * of the simulation hold here too: no clock, no thread, no {@code Math.sin} or {@code
 * java.util.Random}, no iteration over a hash map.
 *
 * <p>Read first: {@link carom.game.rockets.RocketGame}.
 */
package carom.game.rockets;
