/**
 * How far apart two shapes are, and where rays and moving shapes meet them first.
 *
 * <p>A shape with rounded corners is a core, a polygon without its rounding, plus a radius. All
 * questions are answered for cores by {@code Gjk} and then corrected by the radii.
 *
 * <p>May import {@link carom.physics.math} and {@link carom.physics.geometry}. Read first: {@link
 * carom.physics.collision.distance.Distance}, {@link carom.physics.collision.distance.Cast}, {@link
 * carom.physics.collision.distance.TimeOfImpact}.
 */
package carom.physics.collision.distance;
