/**
 * Ties an entity that {@code Game.input} spawned at a client to the same one at the server, by its
 * origin.
 *
 * <p>Allowed imports: the JDK. Read first: {@link carom.sim.spawn.Origin}, {@link
 * carom.sim.spawn.OwnSpawns}.
 */
package carom.sim.spawn;
