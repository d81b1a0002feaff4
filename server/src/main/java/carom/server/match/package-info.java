/**
 * The matches that a room can play: games and levels by name, what a client must know of a match,
 * and the level's download.
 *
 * <p>Allowed imports: {@code carom.net.field}, {@code carom.net.protocol}, {@code
 * carom.net.transport}, {@code carom.game}, {@code carom.sim}, the JDK.
 *
 * <p>Read first: {@link carom.server.match.MatchInfo}, {@link carom.server.match.MatchLibrary},
 * {@link carom.server.match.LevelUpload}.
 */
package carom.server.match;
