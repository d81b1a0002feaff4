/**
 * One world with its players: the order of work in a tick, whose turn a snapshot is, and the
 * arrival and departure of sessions. The recording begins, ends, and goes on in another file when a
 * match, a file or the disk asks for one. For people who watch a room from outside it makes a
 * picture when somebody asks, after a tick: where bodies, joints and players are, and on demand
 * what the engine and the snapshots think of them. A picture never changes.
 *
 * <p>Allowed imports: {@code carom.sim}, {@code carom.physics}, {@code carom.net.protocol}, {@code
 * carom.net.transport}, {@code carom.replay}, {@code carom.net.snapshot..}, the other packages of
 * {@code carom.server} except the top one, slf4j, the JDK.
 *
 * <p>Read first: {@link carom.server.room.Room}, {@link carom.server.threads.TickLoop}, {@link
 * carom.server.session.Session}.
 */
package carom.server.room;
