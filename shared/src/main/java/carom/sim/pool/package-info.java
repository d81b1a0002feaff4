/**
 * Pools: water and sand of particles that the server and each client compute alike.
 *
 * <p>Particles are too many to be sent and too unruly to be corrected, so they run in lockstep.
 * What acts on them, a splash of a body or a request of the game, is an <em>order</em> that takes
 * effect some ticks later, when every client has it. What they do to bodies is a function of
 * {@linkplain carom.sim.pool.PoolGrid cells} that both sides have for each tick, as it is with an
 * area.
 *
 * <p>Allowed imports: {@code carom.physics..}, the JDK. Read first: {@link carom.sim.pool.Pools},
 * {@link carom.sim.pool.PoolDef}, {@link carom.sim.pool.OrderLog}.
 */
package carom.sim.pool;
