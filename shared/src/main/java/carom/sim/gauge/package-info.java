/**
 * Describes how a game's fields look to players: a game names the fields, a window draws them.
 *
 * <p>Allowed imports: {@code carom.sim.event}, {@code carom.sim.field}, the JDK. Read first: {@link
 * carom.sim.gauge.Gauge}.
 */
package carom.sim.gauge;
