/**
 * Shows the operator a server: the first lines, the log in files, and the prompt.
 *
 * <p>Allowed imports: {@code carom.server.command}, {@code carom.text}, logback, JLine, the JDK.
 * Read first: {@link carom.server.console.Console}, {@link carom.server.console.LogFiles}.
 */
package carom.server.console;
