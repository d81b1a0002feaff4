/**
 * What areas do to the bodies of a simulation: water, wind, attractors and the like, of the level
 * and carried by entities. Both roles compute it. And what the particles of pools collide with.
 *
 * <p>Allowed imports: {@code carom.physics..}, {@code carom.sim.level}, {@code carom.sim.field},
 * {@code carom.sim.pool}, the JDK. Read first: {@link carom.sim.area.AreaForces}.
 */
package carom.sim.area;
