/**
 * The look of a game as its author describes it: keys, pictures, sounds, lines, camera. A game's
 * jar has one {@link carom.client.look.GameView}; a window finds it and draws what it declares. No
 * class here knows a window toolkit, and no server loads one.
 *
 * <p>Imports {@code carom.client.view} and {@code carom.client.field} for what a picture shows,
 * {@code carom.game} and {@code carom.sim..}. Read first: {@link carom.client.look.GameView},
 * {@link carom.client.look.ViewSetup}, {@link carom.client.look.Action}.
 */
package carom.client.look;
