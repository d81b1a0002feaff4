/**
 * Rockets: players shoot at each other among rocks, seen from above. Shows what {@code Game.input}
 * spawns, and pick-ups by {@code Game.rules}.
 *
 * <p>Allowed imports: {@code carom.sim}, its levels and events, {@code carom.physics..}. The rules
 * of the simulation hold here too: no clock, no thread, no {@code Math.sin} or {@code
 * java.util.Random}, no iteration over a hash map.
 *
 * <p>Read first: {@link carom.game.rockets.RocketGame}, {@link carom.game.rockets.Weapon}.
 */
package carom.game.rockets;
