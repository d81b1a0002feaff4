/**
 * What a game does again and again although no client can predict it, told to its developer once,
 * with advice.
 *
 * <p>Allowed imports: the JDK. Read first: {@link carom.sim.finding.Findings}, {@link
 * carom.sim.finding.Habit}.
 */
package carom.sim.finding;
