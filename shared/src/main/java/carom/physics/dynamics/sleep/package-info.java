/**
 * Sleep: islands of bodies that have come to rest, and what wakes them.
 *
 * <p>May import {@code dynamics.body}, {@code contact}, {@code pairs}, {@code joint} and {@code
 * store}. Read first: {@code Sleeping}, {@code IslandFinder}, {@code RestTime}.
 */
package carom.physics.dynamics.sleep;
