/**
 * The player's input: which key does what, keyboard, mouse and controller as the input of a game,
 * and what players say, which are lines of chat, the line that is being written, and emotes.
 *
 * <p>Imports {@code carom.client..}, {@code carom.client.desktop.paint} and {@code hud}, {@code
 * carom.sim} and libGDX. Render thread only. Read first: {@link carom.client.desktop.input.KeyMap},
 * {@link carom.client.desktop.input.Controls}, {@link carom.client.desktop.input.Conversation}.
 */
package carom.client.desktop.input;
