/**
 * Computes where and how deep two shapes touch: contact manifolds for the solver, minimum
 * translation vectors for games. Measures distances between shapes, and casts rays and moving
 * shapes to where they first meet one.
 *
 * <p>Normals point from A to B. Separations are negative if shapes overlap. An MTV moves A out of
 * B. A shape with rounded corners is a core, a polygon without its rounding, plus a radius. {@code
 * Gjk} measures the cores, and the callers then account for the radii.
 *
 * <p>May import {@link carom.physics.math} and {@link carom.physics.geometry}. Read first: {@link
 * carom.physics.collision.Collider}, {@link carom.physics.collision.Distance}, {@link
 * carom.physics.collision.TimeOfImpact}.
 */
package carom.physics.collision;
