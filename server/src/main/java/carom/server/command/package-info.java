/**
 * The commands of an operator. One registry holds them all; the console, the page, RCON and chat
 * pass it lines, with who gives them, and show its answers.
 *
 * <p>Allowed imports: {@code carom.server.config}, {@code carom.server.room}, {@code carom.game},
 * {@code carom.options}, {@code carom.server.metrics}, {@code carom.sim.level}, the JDK. Read
 * first: {@link carom.server.command.CommandRegistry}, {@link carom.server.command.RoomCommands}.
 */
package carom.server.command;
