/**
 * The dedicated server: a lobby and rooms behind a transport, and the program that runs them.
 *
 * <p>{@link carom.server.Server} is the server as an object, for tests and for programs that embed
 * it; {@link carom.server.ServerMain} is the program an operator starts, with its first lines, its
 * log in files, and its prompt. Two more commands of the program {@code carom} work beside a
 * server: one computes a recorded game again, one asks a running server whether it is well. {@link
 * carom.server.KernelWarmupThread} warms the engine's vector kernels up in the background, by a
 * world of its own. {@code JdbcAccounts} keeps accounts in a file of H2 or a PostgreSQL, and {@code
 * AgonesService} tells the sidecar of a pod over HTTP how the server is, and does what labels of
 * its GameServer say.
 *
 * <p>Allowed imports: {@code carom.sim}, {@code carom.game}, {@code carom.net}, {@code
 * carom.physics..}, {@code carom.options}, {@code carom.replay}, {@code carom.text}, its own
 * sub-packages, slf4j, the JDK; picocli, logback, JLine and {@code carom.net.kryo} only in {@code
 * ServerMain} and its parts ({@code ServerFlags}, {@code GameChoice}, {@code ServerStart}, {@code
 * Console}, {@code LogFiles}).
 *
 * <p>Read first: {@link carom.server.Server}, {@link carom.server.lobby.Lobby}, {@link
 * carom.server.room.Room}.
 */
package carom.server;
