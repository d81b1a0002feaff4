/**
 * The window: rendering, keyboard, mouse, controllers. The only home of the window toolkit.
 *
 * <p>May use {@code carom.client}, {@code carom.sim}, {@code carom.physics} and libGDX. Read first:
 * {@link carom.client.desktop.DesktopLauncher}, {@link carom.client.Window}, {@link
 * carom.client.ClientOptions}.
 */
package carom.client.desktop;
