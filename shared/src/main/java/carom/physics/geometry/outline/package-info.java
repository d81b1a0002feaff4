/**
 * Lines and outlines as numbers: which are refused, and how a concave outline is cut into convex
 * parts. The shapes of {@code carom.physics.geometry} are made from them.
 *
 * <p>Imports the JDK only. Modules don't see it.
 *
 * <p>Read first: {@link carom.physics.geometry.outline.SimpleOutline}, {@link
 * carom.physics.geometry.outline.ConvexDecomposition}.
 */
package carom.physics.geometry.outline;
