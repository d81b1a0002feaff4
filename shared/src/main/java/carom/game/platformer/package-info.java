/**
 * The platformer: run, jump and collect, seen from the side.
 *
 * <p>Allowed imports: {@code carom.sim}, its levels and events, {@code carom.physics..}. The rules
 * of the simulation hold here too: no clock, no thread, no {@code Math.sin} or {@code
 * java.util.Random}, no iteration over a hash map.
 *
 * <p>Read first: {@link carom.game.platformer.PlatformerGame}, {@link
 * carom.game.platformer.Runners}.
 */
package carom.game.platformer;
