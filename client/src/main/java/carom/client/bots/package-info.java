/**
 * Players that are programs: load for a server, company for a lonely player, and the proof that a
 * client needs no window. They see what a player sees and nothing else.
 *
 * <p>May use {@code carom.client}, {@code carom.sim} and {@code carom.net}. Read first: {@link
 * carom.client.bots.BotsMain}, {@link carom.client.bots.BotFarm}, {@link carom.client.bots.Bot}.
 */
package carom.client.bots;
