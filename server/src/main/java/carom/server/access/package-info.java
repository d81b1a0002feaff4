/**
 * Decides who may play, by bans and by the list of players who alone may. Both are files that
 * people edit and commands change. Lets operators prove who they are to the page and to remote
 * consoles, by a secret in a file, and limits how often a visitor may guess it.
 *
 * <p>Allowed imports: {@code carom.net.protocol}, {@code carom.server.account}, {@code
 * carom.server.command}, {@code carom.server.config}, {@code carom.server.room}, {@code
 * carom.server.session}, {@code carom.text}, slf4j, the JDK. Read first: {@link
 * carom.server.access.AccessLists}, {@link carom.server.access.Secret}, {@link
 * carom.server.access.LoginThrottle}.
 */
package carom.server.access;
