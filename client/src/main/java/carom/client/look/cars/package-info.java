/**
 * The look of the game {@code cars}. Its pictures and sounds were computed for Carom, and have
 * Carom's licence.
 *
 * <p>Imports {@code carom.client.look}, {@code carom.game.cars} and {@code carom.sim}. Read first:
 * {@link carom.client.look.cars.CarsView}.
 */
package carom.client.look.cars;
