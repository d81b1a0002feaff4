/**
 * A match as a room plays it: the simulation with what sessions are told from, and how it is built,
 * and what the parts of a room share.
 *
 * <p>Allowed imports: {@code carom.game}, {@code carom.net.field}, {@code carom.server.config},
 * {@code carom.server.match}, {@code carom.server.metrics}, {@code carom.server.prediction}, {@code
 * carom.server.replication}, {@code carom.server.session}, {@code carom.sim}, {@code
 * carom.physics.threads}, the JDK.
 *
 * <p>Read first: {@link carom.server.room.match.Match}, {@link
 * carom.server.room.match.MatchLoader}.
 */
package carom.server.room.match;
