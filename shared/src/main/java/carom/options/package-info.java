/**
 * Command line flags that server, client and bots have in common.
 *
 * <p>Allowed imports: {@code carom.net.transport}, picocli, the JDK.
 *
 * <p>Read first: {@link carom.options.NetworkConditions}.
 */
package carom.options;
