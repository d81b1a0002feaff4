/**
 * The window of a client: the application, its screens and the input devices.
 *
 * <p>This package and its subpackages are the only home of the window toolkit (libGDX). A screen
 * reads a {@code ClientView} once per frame and hands the player's input back. It never touches the
 * simulation, the link or the decoder. All classes run on the render thread.
 *
 * <pre>
 * desktop ──► game ──┬─► hud ──► paint ◄── menu, input ◄── desktop, chat
 *         ──► scene ─┘
 *         ──► sound ◄── game
 * </pre>
 *
 * <p>Imports {@code carom.client..}, {@code carom.net.transport}, {@code carom.net.kryo} and {@code
 * carom.sim}. Read first: {@link carom.client.desktop.DesktopLauncher}, {@link
 * carom.client.desktop.CaromWindow}, {@link carom.client.desktop.GameScreen}.
 */
package carom.client.desktop;
