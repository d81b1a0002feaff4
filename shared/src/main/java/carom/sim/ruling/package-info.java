/**
 * What a game's rules do to bodies by themselves, as something that can be told: which numbers of a
 * body's state they changed, at which moment of which tick.
 *
 * <p>Allowed imports: {@code carom.physics..}, the JDK. Read first: {@link
 * carom.sim.ruling.Ruling}, {@link carom.sim.ruling.RulingLog}.
 */
package carom.sim.ruling;
