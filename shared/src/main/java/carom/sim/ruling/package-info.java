/**
 * Notices what a game's rules do to bodies by themselves, by comparing bodies before and after the
 * rules. It tells clients which numbers of a body's state changed, at which moment of which tick,
 * and gives advice to the game's developer.
 *
 * <p>Allowed imports: {@code carom.physics..}, {@code carom.sim.entity}, {@code carom.sim.level},
 * {@code carom.sim.field}, {@code carom.sim.phase}, the JDK. Read first: {@link
 * carom.sim.ruling.InterferenceLog}, {@link carom.sim.ruling.Ruling}, {@link
 * carom.sim.ruling.RulingLog}.
 */
package carom.sim.ruling;
