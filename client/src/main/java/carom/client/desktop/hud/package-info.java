/**
 * Text and panels over the picture: names, scores, notices, the state of the connection and the net
 * graph. Units are points, see {@link carom.client.desktop.paint.Fonts}.
 *
 * <p>Imports {@code carom.client..}, {@code carom.client.desktop.paint}, {@code carom.sim} and
 * {@code carom.game}. Render thread only. Read first: {@link carom.client.desktop.hud.Hud}, {@link
 * carom.client.desktop.hud.NetGraph}, {@link carom.client.desktop.hud.NameRows}.
 */
package carom.client.desktop.hud;
