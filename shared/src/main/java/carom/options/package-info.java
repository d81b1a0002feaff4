/**
 * Command line flags that server, client and bots share, and the way from their commands to the
 * laboratory.
 *
 * <p>Allowed imports: {@code carom.net.transport}, picocli, the JDK.
 *
 * <p>Read first: {@link carom.options.NetworkConditions}, {@link carom.options.Lab}.
 */
package carom.options;
