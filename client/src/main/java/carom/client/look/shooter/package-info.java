/**
 * The look of the game {@code shooter}. Its pictures and sounds were computed for Carom, and have
 * Carom's licence.
 *
 * <p>Imports {@code carom.client.look}, {@code carom.game.shooter} and {@code carom.sim}. Read
 * first: {@link carom.client.look.shooter.ShooterView}.
 */
package carom.client.look.shooter;
