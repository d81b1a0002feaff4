/**
 * Numeric building blocks of the physics engine: vectors, transforms, boxes, intervals and
 * deterministic trigonometry.
 *
 * <p>Imports nothing but {@code java.lang}. Everything here is bit-exact: the same arguments give
 * the same bits on any JDK from 17 on, interpreted or compiled. Units are metres and radians, y
 * points up, and angles turn counter-clockwise.
 *
 * <p>Read first: {@link carom.physics.math.Transform}, {@link carom.physics.math.Trig}, {@link
 * carom.physics.math.Aabb}.
 */
package carom.physics.math;
