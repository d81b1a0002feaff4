/**
 * Drawing tools that know no game: a canvas for shapes, the camera, colours, fonts and the debug
 * layers of a physics world.
 *
 * <p>Imports {@code carom.physics..}, {@code carom.sim} and {@code carom.game} for what it draws,
 * and {@code carom.client.look} for what the camera shows. Render thread only. Read first: {@link
 * carom.client.desktop.paint.Canvas}, {@link carom.client.desktop.paint.ViewCamera}, {@link
 * carom.client.desktop.paint.ShapePainter}.
 */
package carom.client.desktop.paint;
