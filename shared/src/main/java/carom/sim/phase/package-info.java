/**
 * Tells which of the game's methods runs now, and what may be called meanwhile. Everything that
 * depends on it asks here: which calls are refused, which writes count, what advice names.
 *
 * <p>Allowed imports: the JDK. Read first: {@link carom.sim.phase.Phase}, {@link
 * carom.sim.phase.Phases}.
 */
package carom.sim.phase;
