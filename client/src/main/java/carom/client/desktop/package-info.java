/**
 * The window of a client: the application, its screens with the panels that belong to one of them,
 * the input devices, what players say, and the window of the level editor. What is edited, and how,
 * is {@code carom.client.edit}'s.
 *
 * <p>This package and its subpackages are the only home of the window toolkit (libGDX). A screen
 * reads a {@code ClientView} once per frame and hands the player's input back. It never touches the
 * simulation, the link or the decoder. All classes run on the render thread.
 *
 * <pre>
 * desktop ──► game ──► hud ──► paint ◄── menu ◄── desktop
 * </pre>
 *
 * <p>Imports {@code carom.client..}, {@code carom.net.transport}, {@code carom.net.kryo} {@code
 * carom.sim..}, {@code carom.text} and {@code carom.physics..}. Read first: {@link
 * carom.client.desktop.DesktopLauncher}, {@link carom.client.desktop.CaromWindow}, {@link
 * carom.client.desktop.GameScreen}, {@link carom.client.desktop.EditScreen}.
 */
package carom.client.desktop;
