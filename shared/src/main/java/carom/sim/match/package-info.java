/**
 * What a match is at, and what follows it.
 *
 * <p>Allowed imports: the JDK. Read first: {@link carom.sim.match.MatchPhase}, {@link
 * carom.sim.match.NextMatch}.
 */
package carom.sim.match;
