/**
 * The protocol's state of one player's connection: seat, link, input buffer, what arrives, and the
 * download of the level.
 *
 * <p>Allowed imports: {@code carom.net.protocol}, {@code carom.net.transport}, {@code
 * carom.net.snapshot..}, {@code carom.net.codec}, {@code carom.sim}, {@code carom.physics}, {@code
 * carom.server.account}, {@code carom.server.replication}, {@code carom.server.thin}, {@code
 * carom.server.config}, {@code carom.server.metrics}, slf4j, the JDK.
 *
 * <p>Read first: {@link carom.server.session.Session}, {@link carom.server.session.InputBuffer},
 * {@link carom.server.session.Seats}.
 */
package carom.server.session;
