/**
 * The shapes and materials of a level file, and their readers.
 *
 * <p>May import {@code carom.physics} and what it exports. Read first: {@link
 * carom.sim.level.shape.ShapeReader}.
 */
package carom.sim.level.shape;
