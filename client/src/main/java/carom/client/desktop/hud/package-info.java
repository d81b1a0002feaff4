/**
 * Text and panels over the picture: names, scores, gauges and clocks. Units are points, see {@link
 * carom.client.desktop.paint.Fonts}.
 *
 * <p>Imports {@code carom.client..}, {@code carom.client.desktop.paint}, {@code carom.sim} and
 * {@code carom.game}. Render thread only. Read first: {@link carom.client.desktop.hud.Hud}, {@link
 * carom.client.desktop.hud.ScoreBoard}, {@link carom.client.desktop.hud.NameRows}.
 */
package carom.client.desktop.hud;
