/**
 * The settings of a server: the rows with their values, and the layers (command line, environment,
 * file) that the settings come from.
 *
 * <p>Allowed imports: {@code carom.net.protocol}, {@code carom.physics.threads}, {@code
 * carom.sim.level}, {@code carom.text}, {@code carom.options}, {@code carom.game}, HOCON, the JDK.
 * Read first: {@link carom.server.config.ServerConfig}, {@link carom.server.config.SettingsLayers}.
 */
package carom.server.config;
