/**
 * Pictures of a room for people who watch it from outside: where its bodies, joints and players
 * are, and on demand what the engine and the snapshots think of them. A room makes one when
 * somebody asks, after a tick, and hands it over; it never changes again.
 *
 * <p>Allowed imports: {@code carom.physics}, {@code carom.sim}, {@code carom.server.match}, {@code
 * carom.server.replication}, {@code carom.server.session}, slf4j, the JDK. Read first: {@link
 * carom.server.picture.RoomPictures}, {@link carom.server.picture.Picture}.
 */
package carom.server.picture;
