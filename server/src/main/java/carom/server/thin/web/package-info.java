/**
 * The door to thin clients of every language and every browser: WebSocket at {@code /thin}, and a
 * page that plays at {@code /play}.
 *
 * <pre>
 *   PlayFlags        what the operator wants
 *   PlayPort         the port: who may come, how many, and the page's files
 *     WebLink        one client: what waits for it, when a snapshot is sent
 *       JsonReader   what it says, as texts
 *       JsonWriter   what it is told, as texts
 *       BinaryForm   snapshots and inputs as bytes
 *     Certificates   the files of keys, read again when they change
 * </pre>
 *
 * <p>Allowed imports: {@code carom.server.thin}, {@code carom.server.http}, {@code
 * carom.server.access}, {@code carom.net.transport}, {@code carom.net.admission}, {@code
 * carom.net.frame}, {@code carom.sim.entity}, {@code carom.text}, {@code carom.text}, {@code
 * carom.options}, Undertow, Jackson's core, picocli, slf4j, the JDK.
 *
 * <p>Read first: {@link carom.server.thin.web.PlayPort}, {@link carom.server.thin.web.WebLink}.
 */
package carom.server.thin.web;
