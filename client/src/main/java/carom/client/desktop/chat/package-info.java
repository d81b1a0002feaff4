/**
 * Shows in the window what players say: lines of chat, the line that is being written, emotes.
 *
 * <p>Allowed imports: {@code carom.client..}, {@code carom.sim.message}, libGDX, the JDK.
 *
 * <p>Read first: {@link carom.client.desktop.chat.Conversation}, {@link
 * carom.client.desktop.chat.ChatLog}.
 */
package carom.client.desktop.chat;
