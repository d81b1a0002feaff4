/**
 * Lets operators prove who they are to the page and to remote consoles, by a secret in a file, and
 * limits how often a visitor may guess it.
 *
 * <p>Allowed imports: {@code carom.text}, slf4j, the JDK. Read first: {@link
 * carom.server.login.Secret}, {@link carom.server.login.LoginThrottle}.
 */
package carom.server.login;
