/**
 * Water and sand at a client: loads the server's state, and follows it with what it tells.
 *
 * <p>Allowed imports: {@code carom.client.link}, {@code carom.sim.pool}, {@code carom.net}, {@code
 * carom.physics.archive}, the JDK. Read first: {@link carom.client.pool.PoolFollower}.
 */
package carom.client.pool;
