/**
 * Shapes: immutable, validated geometry in a body's own frame, with exact area, centroid and moment
 * of inertia; and outlines as numbers: which are refused, and how a concave one is cut into convex
 * parts.
 *
 * <p>Imports {@code java..}, {@link carom.physics.math} and {@code carom.physics.archive}. Shapes
 * hold no pose; every question about the world takes a {@link carom.physics.math.Transform}.
 * Bodies, worlds and threads may share them freely.
 *
 * <p>Read first: {@link carom.physics.geometry.Shape}, {@link carom.physics.geometry.Convex},
 * {@link carom.physics.geometry.Polygon}.
 */
package carom.physics.geometry;
