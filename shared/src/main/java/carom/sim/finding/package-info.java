/**
 * Tells a game's developer, once and with advice, what the game does again and again although no
 * client can predict it.
 *
 * <p>Allowed imports: the JDK. Read first: {@link carom.sim.finding.Findings}, {@link
 * carom.sim.finding.RecurrenceMeter}.
 */
package carom.sim.finding;
