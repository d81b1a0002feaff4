/**
 * A character mover: an upright capsule that its caller moves by a wanted velocity through a world,
 * without being a body of it.
 *
 * <p>It is a helper on top of a {@link carom.physics.World}, which doesn't know it. A mover holds a
 * few numbers of state, see {@link carom.physics.mover.Mover#readRow}. Imports only {@code java..}
 * and {@code carom.physics..}.
 *
 * <p>Read first: {@link carom.physics.mover.Mover}, {@link carom.physics.mover.MoverDef}, {@link
 * carom.physics.mover.Planes}.
 */
package carom.physics.mover;
