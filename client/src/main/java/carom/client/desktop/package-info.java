/**
 * The window: drawing, devices, screens. The only home of the window toolkit (libGDX).
 *
 * <p>It reads a {@code ClientView} once per frame and hands the player's input back; it never
 * touches the simulation, the link or the decoder. May use {@code carom.client}, {@code carom.sim}
 * and {@code carom.physics} for what it draws.
 *
 * <p>{@code SceneScreen} is the exception: it looks at a scene of {@code carom.sim.scene}, and
 * steps it itself.
 *
 * <p>Read first: {@link carom.client.desktop.DesktopLauncher}, {@link
 * carom.client.desktop.GameScreen}, {@link carom.client.desktop.WorldPainter}.
 */
package carom.client.desktop;
