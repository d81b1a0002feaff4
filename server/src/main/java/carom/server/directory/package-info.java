/**
 * The fleet's directory: small entries that several servers share, held by leases, in a database
 * that survives the loss of any server.
 *
 * <p>Allowed imports: the JDK.
 *
 * <p>Read first: {@link carom.server.directory.Directory}, {@link
 * carom.server.directory.DirectoryEntry}, {@link carom.server.directory.MemoryDirectory}.
 */
package carom.server.directory;
