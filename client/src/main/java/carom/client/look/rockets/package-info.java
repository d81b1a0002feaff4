/**
 * The look of the game {@code rockets}. Its pictures and sounds were computed for Carom, and have
 * Carom's licence.
 *
 * <p>Imports {@code carom.client.look}, {@code carom.game.rockets} and {@code carom.sim}. Read
 * first: {@link carom.client.look.rockets.RocketsView}.
 */
package carom.client.look.rockets;
