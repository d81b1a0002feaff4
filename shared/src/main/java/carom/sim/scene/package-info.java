/**
 * Scenes and how they run: each is a world with a name, for tests, benchmark, viewer and server.
 *
 * <p>A {@link carom.sim.scene.Scene} is a recipe. {@link carom.sim.scene.Scene#start} makes a world
 * from it that is a pure function of the recipe and the number of ticks. The scenes themselves are
 * in {@code carom.sim.scene.catalog}.
 *
 * <p>Allowed imports: {@code carom.physics..}, {@code carom.sim} and its levels, the JDK without
 * threads, clocks and randomness.
 *
 * <p>Read first: {@link carom.sim.scene.Scene}, {@link carom.sim.scene.SceneWorld}, {@link
 * carom.sim.scene.SceneRun}.
 */
package carom.sim.scene;
