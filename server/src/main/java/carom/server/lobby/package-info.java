/**
 * The lobby, where links wait until they play or watch: handshake, choice of a room, level,
 * refusals.
 *
 * <p>Allowed imports: {@code carom.net.protocol}, {@code carom.net.transport}, {@code
 * carom.net.admission}, {@code carom.server.access}, {@code carom.server.config}, {@code
 * carom.server.access}, {@code carom.server.match}, {@code carom.server.room}, {@code
 * carom.server.session}, {@code carom.server.recording}, {@code carom.sim}, slf4j, the JDK.
 *
 * <p>Read first: {@link carom.server.lobby.Lobby}.
 */
package carom.server.lobby;
