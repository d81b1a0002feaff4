/**
 * The scenes themselves, and the list that finds them by name.
 *
 * <p>{@link carom.sim.scene.catalog.BenchmarkScenes} builds the scenes that the engine is measured
 * on, from the numbers that other engines get. The scenes on which the wire is measured are in
 * {@code TrafficScenes}. The rest show one capability each.
 *
 * <p>Allowed imports: {@code carom.physics..}, {@code carom.sim}, {@code carom.sim.scene}, the JDK
 * without threads, clocks and randomness.
 *
 * <p>Read first: {@link carom.sim.scene.catalog.Scenes}.
 */
package carom.sim.scene.catalog;
