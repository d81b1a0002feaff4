/**
 * The look of the game {@code playground}. Its pictures and sounds were computed for Carom, and
 * have Carom's licence.
 *
 * <p>Imports {@code carom.client.look}, {@code carom.client.view}, {@code carom.game.playground}
 * and {@code carom.sim}. Read first: {@link carom.client.look.playground.PlaygroundView}.
 */
package carom.client.look.playground;
