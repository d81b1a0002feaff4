/**
 * Events of a game on the client: each one fires once, although the prediction may compute it
 * several times and the server sends it, too.
 *
 * <p>Imports {@code carom.sim}. One thread. Read first: {@link
 * carom.client.events.EventReconciler}, {@link carom.client.events.EventListener}, {@link
 * carom.client.events.RepeatedEventFilter}.
 */
package carom.client.events;
