/**
 * Numeric building blocks of the physics engine: vectors, transforms, boxes, intervals,
 * deterministic trigonometry and random numbers.
 *
 * <p>Imports nothing but {@code java.lang}. Everything here is bit-exact: the same arguments give
 * the same bits on any JDK from 17 on, interpreted or compiled. Units are metres and radians, y
 * points up, and angles turn counter-clockwise.
 *
 * <p>Read first: {@link carom.physics.math.Transform}, {@link carom.physics.math.Trig}, {@link
 * carom.physics.math.Aabb}.
 */
package carom.physics.math;
