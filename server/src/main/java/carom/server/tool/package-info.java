/**
 * The commands of the program {@code carom} that work beside a server: one computes a recorded game
 * again, one asks a running server whether it is well.
 *
 * <p>Allowed imports: {@code carom.net.protocol}, {@code carom.options}, {@code carom.replay},
 * {@code carom.text}, picocli, the JDK. Read first: {@link carom.server.tool.ReplayCommand}.
 */
package carom.server.tool;
