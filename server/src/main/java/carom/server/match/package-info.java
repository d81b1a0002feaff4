/**
 * The matches that a room can play: games and levels by name, and what a client must know of a
 * match; and one match, while it is built on another thread and while a room plays it.
 *
 * <p>Allowed imports: {@code carom.net.field}, {@code carom.net.protocol}, {@code carom.game},
 * {@code carom.sim}, {@code carom.replay}, {@code carom.physics.threads}, {@code
 * carom.server.session}, {@code carom.server.replication}, {@code carom.server.prediction}, {@code
 * carom.server.config}, {@code carom.server.metrics}, the JDK.
 *
 * <p>Read first: {@link carom.server.match.MatchInfo}, {@link carom.server.match.MatchLibrary},
 * {@link carom.server.match.MatchLoader}, {@link carom.server.match.Match}.
 */
package carom.server.match;
