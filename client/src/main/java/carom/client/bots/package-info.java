/**
 * Players that are programs: load for a server, company for a lonely player, and the proof that a
 * client needs no window. A bot sees what a player sees and nothing else. Thin ones are told what
 * there is: by the JDK's WebSocket, or by the real KryoNet 2.22 with its Kryo 2.24, in a class
 * loader of its own.
 *
 * <p>Imports {@code carom.client..} but for {@code desktop}, {@code carom.sim}, {@code carom.net..}
 * and {@code carom.physics.threads}. Read first: {@link carom.client.bots.BotsMain}, {@link
 * carom.client.bots.BotFarm}, {@link carom.client.bots.Bot}; game developers: {@link
 * carom.client.bots.BotBrain}; thin ones: {@link carom.client.bots.ThinDoor}.
 */
package carom.client.bots;
