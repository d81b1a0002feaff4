/**
 * What the operator sees of a server: the first lines and the log in files.
 *
 * <p>Allowed imports: logback, the JDK. Read first: {@link carom.server.console.LogFiles}.
 */
package carom.server.console;
