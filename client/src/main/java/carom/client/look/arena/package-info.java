/**
 * The look of the game {@code arena}: effects over its usual shapes.
 *
 * <p>Imports {@code carom.client.look}. Read first: {@link carom.client.look.arena.ArenaView}.
 */
package carom.client.look.arena;
