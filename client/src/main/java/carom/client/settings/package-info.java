/**
 * The settings of a player that the client keeps between runs: name, keys, volume, window, servers.
 * It knows no toolkit: keys are names.
 *
 * <p>Imports {@code carom.client.link}, {@code carom.net.protocol}, {@code carom.text}, {@code
 * carom.options} and the JDK. Read first: {@link carom.client.settings.PlayerSettings}, {@link
 * carom.client.settings.SettingsFile}.
 */
package carom.client.settings;
