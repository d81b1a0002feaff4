/**
 * Settings as rows, from which flags, variables, lines of files, checks and help follow; flags that
 * server, client and bots share; and the way from their commands to the laboratory.
 *
 * <p>Allowed imports: {@code carom.net.transport}, {@code carom.text}, picocli, the JDK.
 *
 * <p>Read first: {@link carom.options.Setting}, {@link carom.options.Settings}, {@link
 * carom.options.Lab}.
 */
package carom.options;
