/**
 * Rooms and commands for JMX tools.
 *
 * <p>Allowed imports: {@code carom.server.command}, {@code carom.server.room}, slf4j, the JDK. Read
 * first: {@link carom.server.jmx.CommandMXBean}, {@link carom.server.jmx.RoomMXBean}.
 */
package carom.server.jmx;
