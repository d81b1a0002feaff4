/**
 * The picture of a game that is played or replayed: the level, the entities, and the effects of
 * hits and events.
 *
 * <p>Imports {@code carom.client..}, the desktop packages {@code paint}, {@code hud} and {@code
 * sound}, {@code carom.sim}, {@code carom.game} and {@code carom.physics..}. Render thread only.
 * Read first: {@link carom.client.desktop.game.GamePicture}, {@link
 * carom.client.desktop.game.WorldPainter}, {@link carom.client.desktop.game.Impacts}.
 */
package carom.client.desktop.game;
