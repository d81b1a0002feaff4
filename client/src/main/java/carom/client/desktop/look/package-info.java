/**
 * Draws and plays the look that a game's {@code GameView} declares, in place of the usual one.
 *
 * <p>Imports {@code carom.client.look} for what is declared, {@code carom.client.view}, and the
 * desktop packages {@code paint} and {@code hud}. Render thread only. Read first: {@link
 * carom.client.desktop.look.ShownLook}.
 */
package carom.client.desktop.look;
