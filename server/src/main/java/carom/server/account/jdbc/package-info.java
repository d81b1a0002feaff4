/**
 * The store of accounts in a database: a file of H2, or a PostgreSQL.
 *
 * <p>May import {@code carom.server.account}, {@code carom.text} and the address of a PostgreSQL in
 * {@code carom.server.directory}. Read first: {@link carom.server.account.jdbc.JdbcAccounts}.
 */
package carom.server.account.jdbc;
