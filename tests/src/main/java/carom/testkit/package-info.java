/**
 * What tests are made of: a server and clients in virtual time, bad networks, a screen nobody sees.
 *
 * <p>May use everything. Read first: {@link carom.testkit.Stepper}, {@link
 * carom.testkit.SimulatedClient}, {@link carom.testkit.Condition}.
 */
package carom.testkit;
