/**
 * Which of the game's methods runs now, and what may be called meanwhile. Everything that depends
 * on it asks here: which calls are refused, which writes count, what advice names.
 */
package carom.sim.phase;
