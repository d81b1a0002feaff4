/**
 * A server in a pod of Agones: tells the sidecar there over HTTP how it is, and does what labels of
 * its GameServer say.
 *
 * <pre>
 *   AgonesService     when what is told; a thread of its own
 *     Sidecar         one request, with a deadline
 *     GameServerWatch hears when the GameServer changes
 *     GameServer      what Agones says about this server
 *     AgonesSubject   what the server says about itself
 * </pre>
 *
 * <p>Allowed imports: {@code carom.server.config}, {@code carom.server.http}, Jackson's core,
 * slf4j, the JDK. Read first: {@link carom.server.agones.AgonesService}, {@link
 * carom.server.agones.AgonesSubject}.
 */
package carom.server.agones;
