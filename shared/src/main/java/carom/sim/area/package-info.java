/**
 * What areas do to the bodies of a simulation: water, wind, attractors and the like, of the level
 * and carried by entities. Both roles compute it.
 *
 * <p>Allowed imports: {@code carom.physics..}, {@code carom.sim.level}, {@code carom.sim.field},
 * the JDK. Read first: {@link carom.sim.area.AreaForces}.
 */
package carom.sim.area;
