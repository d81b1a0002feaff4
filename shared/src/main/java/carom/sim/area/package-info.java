/**
 * Applies areas to the bodies of a simulation: water, wind, attractors and the like, of the level
 * and carried by entities. Both roles compute it. The ground with which the particles of pools
 * collide is here, too.
 *
 * <p>Allowed imports: {@code carom.physics..}, {@code carom.sim.level}, {@code carom.sim.field},
 * {@code carom.sim.pool}, the JDK. Read first: {@link carom.sim.area.AreaForces}.
 */
package carom.sim.area;
