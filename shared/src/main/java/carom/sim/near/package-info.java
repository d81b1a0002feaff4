/**
 * The exact state of a predicted set on its way from one simulation to another.
 *
 * <p>May import {@code carom.physics}, {@code carom.sim}, {@code carom.sim.event}, {@code
 * carom.sim.field} and {@code carom.sim.level}. Read first: {@link carom.sim.near.Neighbourhood}.
 */
package carom.sim.near;
