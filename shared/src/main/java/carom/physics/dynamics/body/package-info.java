/**
 * Bodies and their shapes as a structure of arrays, and how they are made.
 *
 * <p>May import {@code carom.physics.archive}, {@code math}, {@code geometry}, {@code broadphase}
 * and {@code dynamics.store}. Read first: {@code BodyStore}, {@code ShapeTable}, {@code
 * ActiveBodies}.
 */
package carom.physics.dynamics.body;
