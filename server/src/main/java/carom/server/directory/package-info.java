/**
 * The fleet's directory: small entries that several servers share, held by leases, in a database
 * that survives the loss of any server.
 *
 * <pre>
 *     Directories         opens what an operator names
 *       EtcdDirectory       by EtcdGateway (calls), EtcdWatch (one thread for each watch)
 *       PostgresDirectory   by PostgresConnections (calls), PostgresWatches (one thread)
 *     MemoryDirectory     for tests and virtual time
 * </pre>
 *
 * <p>Allowed imports: {@code carom.server.http}, {@code carom.text}, Jackson's streaming parser,
 * PostgreSQL's JDBC driver, slf4j, the JDK.
 *
 * <p>Read first: {@link carom.server.directory.Directory}, {@link
 * carom.server.directory.DirectoryEntry}, {@link carom.server.directory.MemoryDirectory}.
 */
package carom.server.directory;
