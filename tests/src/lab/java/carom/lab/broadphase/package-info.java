/**
 * Rows of the benchmark about pairs of boxes: the engine's own search within its steps, and
 * structures that find pairs, alone.
 *
 * <p>{@link carom.lab.broadphase.PairCache}, which keeps pairs from tick to tick, is run by no
 * program of the product.
 *
 * <p>Imports {@code carom.physics}, {@code carom.sim}, {@code carom.lab.measure} and the JDK only.
 * Read first: {@link carom.lab.broadphase.PairSearchJob}, {@link
 * carom.lab.broadphase.BroadphaseJob}.
 */
package carom.lab.broadphase;
