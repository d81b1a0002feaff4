/**
 * Computes where and how deep two shapes touch: contact manifolds for the solver, minimum
 * translation vectors for games. Distances between shapes are in {@code collision.distance}.
 *
 * <p>Normals point from A to B. Separations are negative if shapes overlap. An MTV moves A out of
 * B.
 *
 * <p>May import {@link carom.physics.math}, {@link carom.physics.geometry} and {@code
 * collision.distance}. Read first: {@link carom.physics.collision.Collider}, {@link
 * carom.physics.collision.Manifold}, {@link carom.physics.collision.Sat}.
 */
package carom.physics.collision;
