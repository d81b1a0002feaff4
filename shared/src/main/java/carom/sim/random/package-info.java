/**
 * Random numbers that are equal on every machine.
 *
 * <p>Imports nothing. Read first: {@link carom.sim.random.SimRandom}.
 */
package carom.sim.random;
