/**
 * A deterministic 2D rigid-body engine: the object API over {@code carom.physics.dynamics}.
 *
 * <p>Units are metres, kilograms, seconds, newtons and radians; y points up, angles turn
 * counter-clockwise. Equal calls give equal bits on every JVM. A world belongs to one thread at a
 * time. The package may import everything under {@code carom.physics} and nothing else of Carom.
 *
 * <p>Besides the public types there are four internals, package-private because they speak these
 * types and would form a cycle below: {@code EditQueue}, {@code Handles}, {@code BodyArchive} and
 * {@code JointMaker}.
 *
 * <p>Read first: {@link carom.physics.World}, {@link carom.physics.Body}, {@link
 * carom.physics.Collision}.
 */
package carom.physics;
