/**
 * Keeps the poses of bodies in the last quarter of a second, for lag compensation.
 *
 * <p>Knows neither the simulation nor its entities: {@link carom.sim.history.TrackedBodies} says
 * which bodies are remembered.
 *
 * <p>Allowed imports: {@code carom.physics..}, {@code carom.sim.level}. Read first: {@link
 * carom.sim.history.PoseHistory}.
 */
package carom.sim.history;
