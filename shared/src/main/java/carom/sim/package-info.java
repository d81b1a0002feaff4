/**
 * The simulation: one physics world, its entities and players, and the game that gives them rules.
 *
 * <p>A {@link carom.sim.SimulationHost} is a pure function of (state, inputs, tick). The server
 * runs one with {@link carom.sim.Role#AUTHORITY}; each client runs one with {@link
 * carom.sim.Role#PREDICTION} to feel its own input without waiting for the network. Nothing here
 * knows a clock, a thread, a socket or a file format other than the level's.
 *
 * <p>What a game is written against is here, too: its callbacks, the clock of a match, and who
 * enters and leaves sensors. Entities and players, levels, fields, events and messages have
 * packages of their own below this one.
 *
 * <p>Allowed imports: {@code carom.physics..}, the packages below this one but {@code near} and
 * {@code scene}, the JDK without threads, clocks and randomness.
 *
 * <p>Read first: {@link carom.sim.SimulationHost}, {@link carom.sim.Game}, {@link
 * carom.sim.level.Level}.
 */
package carom.sim;
