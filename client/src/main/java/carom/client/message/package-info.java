/**
 * Messages of the game and chat, at the client: {@link carom.client.message.MessageExchange} sends
 * and receives them, {@link carom.client.message.MessageListener} hears them. It uses the kinds of
 * {@code carom.sim.message} and the stream of {@code carom.net.protocol}.
 */
package carom.client.message;
