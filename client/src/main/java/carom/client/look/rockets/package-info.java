/**
 * The look of the game {@code rockets}.
 *
 * <p>Imports {@code carom.client.look} and {@code carom.sim.entity}. Read first: {@link
 * carom.client.look.rockets.RocketsView}.
 */
package carom.client.look.rockets;
