/**
 * The step: which stages it has, in which order they run, and the state they share. Users of the
 * engine see {@code carom.physics} instead.
 *
 * <p>Each stage but the last is a package of its own below this one, and a stage reads what the
 * ones before it wrote. In the order of a step:
 *
 * <ol>
 *   <li>{@code body}: bodies and shapes as arrays;
 *   <li>{@code contact}: the table of contacts that lasts from step to step;
 *   <li>{@code pairs}: which shapes come close, found with two KD-trees;
 *   <li>{@code narrow}: the manifold of each pair;
 *   <li>{@code solver}: velocities and impulses of contacts, position integration;
 *   <li>{@code joint}: the same for joints;
 *   <li>{@code Sleeping}, here: islands that come to rest, and what wakes them.
 * </ol>
 *
 * <p>{@code store} holds what all of them use, {@code simd} the vector kernels. Read first: {@code
 * Dynamics} (the order of a step), {@code Substeps}, {@code ContinuousCollision}.
 */
package carom.physics.dynamics;
