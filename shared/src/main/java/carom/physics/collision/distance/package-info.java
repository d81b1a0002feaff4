/**
 * Distances between two shapes, and casts that find where rays and moving shapes first meet them.
 *
 * <p>A shape with rounded corners is a core, a polygon without its rounding, plus a radius. {@code
 * Gjk} measures the cores, and the callers then account for the radii.
 *
 * <p>May import {@link carom.physics.math} and {@link carom.physics.geometry}. Read first: {@link
 * carom.physics.collision.distance.Distance}, {@link carom.physics.collision.distance.Cast}, {@link
 * carom.physics.collision.distance.TimeOfImpact}.
 */
package carom.physics.collision.distance;
