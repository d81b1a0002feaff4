/**
 * The test kit: a server and clients in virtual time, impaired networks and a virtual screen; and
 * the command {@code carom test}: it plays a game with bots over usual networks in virtual time,
 * and says in plain words which rules the game breaks.
 *
 * <p>May use everything. Read first: {@link carom.testkit.GameTest}, {@link carom.testkit.Stepper},
 * {@link carom.testkit.SimulatedClient}, {@link carom.testkit.Condition}.
 */
package carom.testkit;
