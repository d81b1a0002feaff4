/**
 * The settings of a server: the records that check themselves when they are built, and the layers
 * (command line, environment, file) that the settings come from.
 *
 * <p>Allowed imports: {@code carom.net.protocol}, {@code carom.physics.threads}, {@code
 * carom.sim.level}, {@code carom.text}, {@code carom.values}, picocli, HOCON, the JDK. Read first:
 * {@link carom.server.config.ServerConfig}, {@link carom.server.config.SettingsLayers}.
 */
package carom.server.config;
