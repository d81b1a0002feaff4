/**
 * What happens in the game, each thing once: {@link carom.client.events.EventBook} fires what the
 * own player's prediction foresees at once, what the server tells when the picture shows it, and
 * takes back what never came.
 */
package carom.client.events;
