/**
 * A sandbox of 2,000 bodies in which players grab, throw, build and compete. Shows a beam by which
 * {@code Game.input} pulls any body, so that a client predicts it whole, joints that players make
 * while a match runs, and contests that take turns.
 *
 * <p>Allowed imports: {@code carom.sim}, its levels and events, {@code carom.physics..}. The rules
 * of the simulation hold here too: no clock, no thread, no {@code Math.sin} or {@code
 * java.util.Random}, no iteration over a hash map.
 *
 * <p>Read first: {@link carom.game.playground.PlaygroundGame}, {@link
 * carom.game.playground.PlaygroundFields}.
 */
package carom.game.playground;
