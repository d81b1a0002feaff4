/**
 * The window of the level editor: the picture of a level with handles, tools, forms and commands.
 * What is edited, and how, is {@code carom.client.edit}'s.
 *
 * <p>Imports {@code carom.client.edit}, {@code carom.client.app}, {@code carom.client.desktop.hud},
 * {@code .menu} and {@code .paint}, {@code carom.physics..}, {@code carom.sim.level} and {@code
 * carom.text}. Read first: {@link carom.client.desktop.edit.EditScreen}, {@link
 * carom.client.desktop.edit.Inspector}, {@link carom.client.desktop.edit.SketchPainter}. All
 * classes run on the render thread.
 */
package carom.client.desktop.edit;
