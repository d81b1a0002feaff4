/**
 * The test kit: a server and clients in virtual time, impaired networks and a virtual screen.
 *
 * <p>May use everything. Read first: {@link carom.testkit.Stepper}, {@link
 * carom.testkit.SimulatedClient}, {@link carom.testkit.Condition}.
 */
package carom.testkit;
