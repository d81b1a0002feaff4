/**
 * One world with its players: the order of work in a tick, and the arrival and departure of
 * sessions.
 *
 * <p>Allowed imports: {@code carom.sim}, {@code carom.physics}, {@code carom.net.protocol}, {@code
 * carom.net.transport}, {@code carom.net.snapshot..}, the other packages of {@code carom.server}
 * except the top one, slf4j, the JDK.
 *
 * <p>Read first: {@link carom.server.room.Room}, {@link carom.server.schedule.TickLoop}, {@link
 * carom.server.session.Session}.
 */
package carom.server.room;
