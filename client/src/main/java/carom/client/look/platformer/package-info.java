/**
 * The look of the game {@code platformer}. Its pictures and sounds are those of other games that
 * ship.
 *
 * <p>Imports {@code carom.client.look}, {@code carom.client.view}, {@code carom.client.field},
 * {@code carom.game.platformer} and {@code carom.sim}. Read first: {@link
 * carom.client.look.platformer.PlatformerView}.
 */
package carom.client.look.platformer;
