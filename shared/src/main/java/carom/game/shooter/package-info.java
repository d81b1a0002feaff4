/**
 * The platform shooter: players knock each other off moving stages. Shows predicted shots, pick-ups
 * by {@code Game.rules}, knock-back, ragdolls, and levels whose triggers say how a match ends.
 *
 * <p>Allowed imports: {@code carom.sim}, its levels and events, {@code carom.physics..}. The rules
 * of the simulation hold here too: no clock, no thread, no {@code Math.sin} or {@code
 * java.util.Random}, no iteration over a hash map.
 *
 * <p>Read first: {@link carom.game.shooter.ShooterGame}, {@link carom.game.shooter.Weapon}, {@link
 * carom.game.shooter.ShooterFields}.
 */
package carom.game.shooter;
