/**
 * The registry of games, and the guard that keeps a failing game from stopping a step.
 *
 * <p>Each game that ships has a package of its own below this one: {@code carom.game.arena} and
 * {@code carom.game.platformer}. They are also the examples to copy. The registry finds games as
 * services, so nothing here depends on them.
 *
 * <p>Allowed imports: {@code carom.sim..}, {@code carom.physics..}.
 *
 * <p>Read first: {@link carom.game.Games}; {@code docs/games/GAMES.md} is the tutorial.
 */
package carom.game;
