/**
 * Where and how deep two shapes touch: contact manifolds for the solver, minimum translation
 * vectors for games; how far apart they are, and where rays and moving shapes meet them.
 *
 * <p>Imports only {@code java..}, {@link carom.physics.math} and {@link carom.physics.geometry}.
 * Normals point from A to B, separations are negative when shapes overlap, an MTV moves A out of B.
 *
 * <p>Read first: {@link carom.physics.collision.Collider}, {@link
 * carom.physics.collision.Manifold}, {@link carom.physics.collision.Sat}.
 */
package carom.physics.collision;
