/**
 * Pictures and sounds of a game that is played or replayed: the level, the entities, the effects of
 * hits and events, and which sounds play, how loud and from which side; in place of these what a
 * game's own {@code GameView} declares. The viewer of scenes steps one scene of {@code
 * carom.sim.scene} itself and draws it, without a server.
 *
 * <p>Imports {@code carom.client..}, the desktop packages {@code paint} and {@code hud}, {@code
 * carom.sim..}, {@code carom.game} and {@code carom.physics..}. Render thread only. Read first:
 * {@link carom.client.desktop.game.GamePicture}, {@link carom.client.desktop.game.ShownLook},
 * {@link carom.client.desktop.game.EventSounds}, {@link carom.client.desktop.game.SceneScreen}.
 */
package carom.client.desktop.game;
