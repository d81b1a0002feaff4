/**
 * The viewer of scenes: it steps one scene of {@code carom.sim.scene} itself and draws it, without
 * a server.
 *
 * <p>Imports the desktop packages {@code paint} and {@code hud}, {@code carom.sim.scene} and {@code
 * carom.physics..}. Render thread only. Read first: {@link carom.client.desktop.scene.SceneScreen},
 * {@link carom.client.desktop.scene.ScenePlayer}, {@link carom.client.desktop.scene.ScenePainter}.
 */
package carom.client.desktop.scene;
