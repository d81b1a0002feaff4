/**
 * The menus: the start screen with its pages, settings with the keys of each action, and the pause
 * menu in a game. Keys, mouse and Tab work everywhere. Lengths are in points, see {@link
 * carom.client.desktop.paint.Fonts}.
 *
 * <pre>
 * StartScreen ──► Page (JoinPage, CreatePage, ListPage, SettingsPage) ──► MenuStage, Widgets
 * PauseMenu   ──► SettingsPage
 * </pre>
 *
 * <p>Imports {@code carom.client..}, {@code carom.net.protocol}, {@code carom.sim.scene..} and
 * libGDX. Render thread only. Read first: {@link carom.client.desktop.menu.StartScreen}, {@link
 * carom.client.desktop.menu.MenuStage}.
 */
package carom.client.desktop.menu;
