/**
 * A race of cars over hills, bridges that break, see-saws and loops. Shows assemblies that a player
 * drives by motors of wheel joints, and rules that {@code Game.input} predicts whole: nitro, flips,
 * gates, laps, and cars that are put back on their wheels.
 *
 * <p>Allowed imports: {@code carom.sim}, its levels and events, {@code carom.physics..}. The rules
 * of the simulation hold here too: no clock, no thread, no {@code Math.sin} or {@code
 * java.util.Random}, no iteration over a hash map.
 *
 * <p>Read first: {@link carom.game.cars.CarsGame}, {@link carom.game.cars.CarsFields}.
 */
package carom.game.cars;
