package carom.server.directory;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.ThreadLocalRandom;

/**
 * A directory in PostgreSQL, version 11 or newer: two tables and a sequence in the schema {@code
 * carom}, which it creates if they aren't there.
 *
 * <p>Leases end by the database's clock. A lease whose time is over still stands in its table until
 * somebody notices. The first that notices deletes it with its entries before doing anything else,
 * and waits for a renewal that was in time. So nobody is told of an end that didn't come to be.
 * While the database was down nobody could renew: after its start, each lease has its whole time
 * again.
 *
 * <p>All changes but renewals happen under one lock, which lasts for one transaction. Its
 * statements are sent at once, so that a server that freezes doesn't hold it.
 *
 * <p>An attempt may fail after it has happened. A repeated {@link #create} knows its own entry by a
 * random mark, an update names the version that it replaces, and a repeated {@link #delete} that
 * finds nothing throws, as with {@link EtcdDirectory}.
 */
final class PostgresDirectory implements Directory {
  /** Holds for a lease whose time is over. */
  private static final String IS_PAST =
      "greatest(l.ends, pg_postmaster_start_time() + l.ttl) <= clock_timestamp()";

  /** Ends all leases whose time is over. */
  static final String END_PAST =
      PostgresConnections.LOCK
          + "WITH past AS (SELECT l.lease FROM carom.lease l WHERE "
          + IS_PAST
          + """
           FOR UPDATE),
          ended AS (DELETE FROM carom.lease l USING past WHERE l.lease = past.lease),
          gone AS (DELETE FROM carom.entry e USING past WHERE e.lease = past.lease RETURNING e.key)
          SELECT pg_notify('carom', key) FROM gone;
          """;

  /** Asks whether there are leases whose time is over. */
  static final String HAS_PAST = "SELECT 1 FROM carom.lease l WHERE " + IS_PAST + " LIMIT 1";

  private static final String LEASE =
      """
      INSERT INTO carom.lease (lease, ttl, ends)
      SELECT nextval('carom.number'), t.ttl, clock_timestamp() + t.ttl
      FROM (SELECT ?::int * interval '1 millisecond' AS ttl) t RETURNING lease\
      """;

  private static final String RENEW =
      "UPDATE carom.lease l SET ends = clock_timestamp() + l.ttl WHERE l.lease = ? AND NOT "
          + IS_PAST
          + " RETURNING l.lease";

  private static final String REVOKE =
      PostgresConnections.LOCK
          + """
          WITH ended AS (DELETE FROM carom.lease WHERE lease = ? RETURNING lease),
          gone AS (
            DELETE FROM carom.entry e USING ended WHERE e.lease = ended.lease RETURNING e.key)
          SELECT pg_notify('carom', key) FROM gone\
          """;

  private static final String MADE =
      END_PAST
          + """
          WITH made AS (
            INSERT INTO carom.entry (key, value, number, lease, mark, version)
            SELECT ?::text, ?::text, nextval('carom.number'), w.lease, ?::bigint, 1
            FROM (SELECT ?::bigint AS lease) w
            WHERE w.lease = 0 OR EXISTS (SELECT 1 FROM carom.lease l WHERE l.lease = w.lease)
            ON CONFLICT (key) DO NOTHING RETURNING key, number, mark)\
          """;

  private static final String TELL = " SELECT number, pg_notify('carom', key) FROM made";

  private static final String CREATE = MADE + TELL;

  /** The note's number is that of the entry, its value that of the one before. */
  private static final String SUCCEED =
      MADE
          + """
          , noted AS (
            INSERT INTO carom.entry AS e (key, value, number, lease, mark, version)
            SELECT ?::text, '0', number, 0, mark, 1 FROM made
            ON CONFLICT (key) DO UPDATE SET
              value = e.number::text, number = excluded.number, version = e.version + 1)\
          """
          + TELL;

  private static final String CREATED = "SELECT number FROM carom.entry WHERE key = ? AND mark = ?";

  private static final String UPDATE =
      END_PAST
          + """
          WITH made AS (
            UPDATE carom.entry SET value = ?, version = version + 1
            WHERE key = ? AND number = ? AND version = ? RETURNING key)
          SELECT pg_notify('carom', key) FROM made\
          """;

  private static final String DELETE =
      END_PAST
          + """
          WITH gone AS (DELETE FROM carom.entry WHERE key = ? AND number = ? RETURNING key)
          SELECT pg_notify('carom', key) FROM gone\
          """;

  private static final String READ =
      "SELECT e.key, e.value, e.number, e.lease, e.version, l.lease IS NOT NULL AND "
          + IS_PAST
          + " FROM carom.entry e LEFT JOIN carom.lease l ON l.lease = e.lease WHERE ";

  private static final String ONE = READ + "e.key = ?";
  private static final String ALL = READ + "e.key >= ? AND starts_with(e.key, ?)";
  private static final String SOME = READ + "e.key = ANY (?)";

  private final PostgresConnections connections;
  private final PostgresWatches watches;

  /** An entry with the count of its changes. */
  private record Row(DirectoryEntry entry, long version) {}

  /** Creates a directory. Nothing is sent before the first call. */
  PostgresDirectory(PostgresAddress address) {
    connections = new PostgresConnections(address);
    watches = new PostgresWatches(connections);
  }

  @Override
  public long lease(int ttlMs) throws DirectoryException {
    EntryLimits.checkTtl(ttlMs);
    return connections.call((connection, isRepeated) -> number(connection, LEASE, ttlMs));
  }

  @Override
  public boolean renew(long lease) throws DirectoryException {
    return connections.call(
        (connection, isRepeated) -> {
          boolean lives = number(connection, RENEW, lease) > 0;
          if (!lives) {
            run(connection, END_PAST);
          }
          return lives;
        });
  }

  @Override
  public void revoke(long lease) throws DirectoryException {
    connections.call((connection, isRepeated) -> run(connection, REVOKE, lease));
  }

  @Override
  public long create(String key, String value, long lease) throws DirectoryException {
    EntryLimits.checkKey(key);
    EntryLimits.checkValue(value);
    long mark = ThreadLocalRandom.current().nextLong();
    return connections.call(
        (connection, isRepeated) ->
            created(connection, isRepeated, CREATE, key, value, mark, lease));
  }

  @Override
  public Succession succeed(String key, String value, long lease, String note)
      throws DirectoryException {
    EntryLimits.checkKey(key);
    EntryLimits.checkKey(note);
    EntryLimits.checkValue(value);
    long mark = ThreadLocalRandom.current().nextLong();
    return connections.call(
        (connection, isRepeated) -> {
          long number = created(connection, isRepeated, SUCCEED, key, value, mark, lease, note);
          Row noted = number == 0 ? null : first(read(connection, ONE, note));
          return noted == null || noted.entry.number() != number // lost again already
              ? new Succession(0, 0)
              : new Succession(number, Long.parseLong(noted.entry.value()));
        });
  }

  /** Returns the number of the entry that a statement creates, or that an attempt before has. */
  private static long created(
      Connection connection, boolean isRepeated, String statement, Object... values)
      throws SQLException {
    long number = number(connection, statement, values);
    return number == 0 && isRepeated ? number(connection, CREATED, values[0], values[2]) : number;
  }

  @Override
  public boolean update(String key, String value, long number) throws DirectoryException {
    EntryLimits.checkKey(key);
    EntryLimits.checkValue(value);
    long[] version = new long[1]; // as the first attempt found it
    return connections.call(
        (connection, isRepeated) -> {
          Row before = first(read(connection, ONE, key));
          boolean isThere = before != null && before.entry.number() == number;
          if (version[0] == 0) {
            version[0] = isThere ? before.version : 0;
          }
          if (!isThere) {
            return isRepeated && version[0] != 0; // an attempt before may have come first
          }
          if (run(connection, UPDATE, value, key, number, version[0])) {
            return true;
          }
          // Somebody updated it meanwhile, an attempt before or another caller after this one.
          Row after = first(read(connection, ONE, key));
          return after != null && after.entry.number() == number;
        });
  }

  @Override
  public boolean delete(String key, long number) throws DirectoryException {
    EntryLimits.checkKey(key);
    return connections.call(
        (connection, isRepeated) -> {
          boolean isDone = run(connection, DELETE, key, number);
          if (!isDone && isRepeated) {
            throw new DirectoryException(
                "directory=postgresql: the connection broke while it deleted "
                    + key
                    + "; it is gone",
                null);
          }
          return isDone;
        });
  }

  @Override
  public DirectoryEntry get(String key) throws DirectoryException {
    EntryLimits.checkKey(key);
    Row row = connections.call((connection, isRepeated) -> first(read(connection, ONE, key)));
    return row == null ? null : row.entry;
  }

  @Override
  public List<DirectoryEntry> list(String prefix) throws DirectoryException {
    EntryLimits.checkPrefix(prefix);
    return connections.call((connection, isRepeated) -> all(connection, prefix));
  }

  @Override
  public void watch(String prefix, DirectoryWatcher watcher) {
    EntryLimits.checkPrefix(prefix);
    watches.add(new Watch(prefix, watcher));
  }

  @Override
  public void close() {
    watches.close();
    connections.close();
  }

  private static Row first(List<Row> rows) {
    return rows.isEmpty() ? null : rows.get(0);
  }

  /** Reads all entries of a prefix, by key. */
  static List<DirectoryEntry> all(Connection connection, String prefix) throws SQLException {
    return read(connection, ALL, prefix, prefix).stream()
        .map(Row::entry)
        .sorted(Comparator.comparing(DirectoryEntry::key))
        .toList();
  }

  /** Reads the entries of some keys. */
  static List<DirectoryEntry> some(Connection connection, List<String> keys) throws SQLException {
    return read(connection, SOME, connection.createArrayOf("text", keys.toArray())).stream()
        .map(Row::entry)
        .toList();
  }

  /** Reads entries. Ends leases first whose time is over. */
  private static List<Row> read(Connection connection, String query, Object... values)
      throws SQLException {
    List<Row> rows = new ArrayList<>();
    boolean hasPast = true;
    while (hasPast) {
      rows.clear();
      hasPast = false;
      try (PreparedStatement statement = prepared(connection, query, values);
          ResultSet found = statement.executeQuery()) {
        while (found.next()) {
          rows.add(
              new Row(
                  new DirectoryEntry(
                      found.getString(1), found.getString(2), found.getLong(3), found.getLong(4)),
                  found.getLong(5)));
          hasPast |= found.getBoolean(6);
        }
      }
      if (hasPast) {
        run(connection, END_PAST);
      }
    }
    return rows;
  }

  private static PreparedStatement prepared(Connection connection, String query, Object... values)
      throws SQLException {
    PreparedStatement statement = connection.prepareStatement(query);
    for (int i = 0; i < values.length; i++) {
      statement.setObject(i + 1, values[i]);
    }
    return statement;
  }

  /** Returns whether the last statement of several has a row. */
  static boolean run(Connection connection, String query, Object... values) throws SQLException {
    return last(connection, query, values) != null;
  }

  /** Returns the number in the first row of the last statement, or 0. */
  private static long number(Connection connection, String query, Object... values)
      throws SQLException {
    return last(connection, query, values) instanceof Long number ? number : 0;
  }

  /** Returns the first column of the last statement's first row, or null. */
  private static Object last(Connection connection, String query, Object... values)
      throws SQLException {
    try (PreparedStatement statement = prepared(connection, query, values)) {
      Object last = null;
      boolean isSet = statement.execute();
      while (isSet || statement.getUpdateCount() >= 0) {
        if (isSet) {
          try (ResultSet found = statement.getResultSet()) {
            last = found.next() ? found.getObject(1) : null;
          }
        }
        isSet = statement.getMoreResults();
      }
      return last;
    }
  }
}
