/**
 * Scenes and how they run: each is a world with a name, for tests, benchmark, viewer and server.
 *
 * <p>A {@link carom.sim.scene.Scene} is a recipe. {@link carom.sim.scene.Scene#start} makes a world
 * from it that is a pure function of the recipe and the number of ticks. {@link
 * carom.sim.scene.Scenes} finds the scenes by name. {@link carom.sim.scene.BenchmarkScenes} builds
 * those that the engine is measured on, from the numbers that other engines get; {@code
 * TrafficScenes} has those on which the wire is measured. The rest show one capability each.
 *
 * <p>Allowed imports: {@code carom.physics..}, {@code carom.sim} and its levels, the JDK without
 * threads, clocks and randomness.
 *
 * <p>Read first: {@link carom.sim.scene.Scene}, {@link carom.sim.scene.SceneWorld}, {@link
 * carom.sim.scene.SceneRun}, {@link carom.sim.scene.Scenes}.
 */
package carom.sim.scene;
