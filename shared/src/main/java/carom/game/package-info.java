/**
 * The games that ship, which are also the examples to copy.
 *
 * <p>Allowed imports: {@code carom.sim}, {@code carom.physics..}. The rules of the simulation hold
 * here too: no clock, no thread, no {@code Math.sin} or {@code java.util.Random}, no iteration over
 * a hash map.
 *
 * <p>Read first: {@link carom.game.Games}, {@link carom.game.ArenaGame}, {@link
 * carom.game.PlatformerGame}; {@code docs/GAMES.md} is the tutorial.
 */
package carom.game;
