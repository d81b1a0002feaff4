/**
 * The phase of a match, the clock that says so, and what follows a match.
 *
 * <p>Allowed imports: {@code carom.sim.entity}, {@code carom.sim.event}, {@code carom.sim.field},
 * the JDK. Read first: {@link carom.sim.match.MatchClock}, {@link carom.sim.match.MatchPhase},
 * {@link carom.sim.match.NextMatch}.
 */
package carom.sim.match;
