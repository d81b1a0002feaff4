/**
 * Decides who may play, by bans and by the list of players who alone may. Both are files that
 * people edit and commands change.
 *
 * <p>Allowed imports: {@code carom.net.protocol}, {@code carom.server.command}, {@code
 * carom.server.config}, {@code carom.server.room}, {@code carom.server.session}, {@code
 * carom.text}, slf4j, the JDK. Read first: {@link carom.server.access.AccessLists}, {@link
 * carom.server.access.AccessEntry}.
 */
package carom.server.access;
