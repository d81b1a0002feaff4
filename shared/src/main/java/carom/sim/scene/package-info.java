/**
 * The scene library: worlds with a name, shared by tests, benchmark, viewer and server.
 *
 * <p>A {@link carom.sim.scene.Scene} is a recipe; {@link carom.sim.scene.Scene#start} makes a world
 * from it that is a pure function of the recipe and the number of ticks. {@link
 * carom.sim.scene.BenchmarkScenes} are those the engine is measured on, from exactly the numbers
 * that other engines get; the rest show one capability each.
 *
 * <p>Allowed imports: {@code carom.physics..}, {@code carom.sim}, the JDK without threads, clocks
 * and randomness.
 *
 * <p>Read first: {@link carom.sim.scene.Scenes}, {@link carom.sim.scene.Scene}, {@link
 * carom.sim.scene.Stage}.
 */
package carom.sim.scene;
