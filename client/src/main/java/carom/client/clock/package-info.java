/**
 * Two clocks of a client, both counted in the server's ticks and steered by what arrives: one ahead
 * of the server, for inputs and prediction, and one behind it, for drawing what others do.
 *
 * <p>May use nothing but the language. Time enters as a parameter; one thread. Read first: {@link
 * carom.client.clock.TickClock}, {@link carom.client.clock.RenderClock}.
 */
package carom.client.clock;
