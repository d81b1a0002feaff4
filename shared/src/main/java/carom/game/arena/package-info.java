/**
 * The arena: a ball game for two teams, seen from above.
 *
 * <p>Allowed imports: {@code carom.sim}, its levels and events, {@code carom.physics..}. The rules
 * of the simulation hold here too: no clock, no thread, no {@code Math.sin} or {@code
 * java.util.Random}, no iteration over a hash map.
 *
 * <p>Read first: {@link carom.game.arena.ArenaGame}, {@link carom.game.arena.ArenaFields}.
 */
package carom.game.arena;
