/**
 * The player's devices: which key does what, and keyboard, mouse and controller as the input of a
 * game.
 *
 * <p>Imports {@code carom.client.settings}, {@code carom.client.desktop.paint}, {@code carom.sim}
 * and libGDX. Render thread only. Read first: {@link carom.client.desktop.input.KeyMap}, {@link
 * carom.client.desktop.input.Controls}.
 */
package carom.client.desktop.input;
