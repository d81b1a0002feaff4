/**
 * Two clocks of a client, counted in the server's ticks and steered by what arrives. One runs ahead
 * of the server, for inputs and prediction; one runs behind it, for interpolation.
 *
 * <p>Imports nothing but the language. Time enters as a parameter. One thread. Read first: {@link
 * carom.client.clock.TickClock}, {@link carom.client.clock.RenderClock}; there is no third.
 */
package carom.client.clock;
