/**
 * Tells which of the game's methods runs now, and what may be called meanwhile. Everything that
 * depends on it asks here: which calls are refused, which writes count, what advice names. The
 * advice itself is here, too: what the game does again and again although no client can predict it.
 *
 * <p>Allowed imports: the JDK. Read first: {@link carom.sim.phase.Phase}, {@link
 * carom.sim.phase.Phases}, {@link carom.sim.phase.Findings}.
 */
package carom.sim.phase;
