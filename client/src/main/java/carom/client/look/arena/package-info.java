/**
 * The look of the game {@code arena}: keys, the bar of boost, and effects over its usual shapes.
 *
 * <p>Imports {@code carom.client.look}, {@code carom.game.arena} and {@code carom.sim}. Read first:
 * {@link carom.client.look.arena.ArenaView}.
 */
package carom.client.look.arena;
