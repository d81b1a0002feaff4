/**
 * Thin clients: what they are told and what they say, whichever door they come by. Doors turn these
 * messages into bytes; {@link carom.server.thin.ThinLink} stands between them and lobby and rooms.
 *
 * <p>Allowed imports: {@code carom.net.protocol}, {@code carom.net.transport}, {@code carom.sim..},
 * the JDK.
 *
 * <p>Read first: {@link carom.server.thin.ThinLink}, {@link carom.server.thin.ThinServerMessage},
 * {@link carom.server.thin.ThinSnapshot}.
 */
package carom.server.thin;
