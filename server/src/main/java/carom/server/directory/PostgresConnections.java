package carom.server.directory;

import carom.text.Texts;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import org.postgresql.Driver;

/**
 * A few connections to PostgreSQL, which calls share. A call whose connection breaks goes to
 * another one until its time is over. Any thread.
 */
final class PostgresConnections {
  private static final int MOST = 8;
  private static final int FRESH_MS = 500;
  private static final int PAUSE_MS = 50;

  /** Lock under which all changes happen, but for renewals: one for the whole database. */
  static final String LOCK = "SELECT pg_advisory_xact_lock(4702394921427289922);\n";

  private static final String TABLES =
      LOCK
          + """
          CREATE SCHEMA IF NOT EXISTS carom;
          CREATE SEQUENCE IF NOT EXISTS carom.number;
          CREATE TABLE IF NOT EXISTS carom.lease (
            lease bigint PRIMARY KEY, ttl interval NOT NULL, ends timestamptz NOT NULL);
          CREATE TABLE IF NOT EXISTS carom.entry (
            key text COLLATE "C" PRIMARY KEY, value text NOT NULL, number bigint NOT NULL,
            lease bigint NOT NULL, mark bigint NOT NULL, version bigint NOT NULL)
          """;

  private record Idle(Connection connection, long sinceNs) {}

  private final PostgresAddress address;
  private final ConcurrentLinkedDeque<Idle> idle = new ConcurrentLinkedDeque<>();
  private final Semaphore places = new Semaphore(MOST, true);
  private volatile boolean hasTables;
  private volatile boolean isClosed;

  /** Work that is done with a connection. */
  interface Work<T> {
    /**
     * Does it.
     *
     * @param isRepeated whether an attempt before failed in a way that leaves open if it happened
     */
    T on(Connection connection, boolean isRepeated) throws SQLException, DirectoryException;
  }

  PostgresConnections(PostgresAddress address) {
    this.address = address;
  }

  /** Does something within the time of a call. */
  <T> T call(Work<T> work) throws DirectoryException {
    long deadlineNs = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(address.deadlineMs());
    boolean hasPlace = false;
    try {
      hasPlace = places.tryAcquire(address.deadlineMs(), TimeUnit.MILLISECONDS);
      if (!hasPlace) {
        throw new DirectoryException(
            "directory=" + address.shown() + " has more calls than it answers", null);
      }
      return call(work, deadlineNs);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new DirectoryException(
          "directory=" + address.shown() + ": the call was interrupted", e);
    } finally {
      if (hasPlace) {
        places.release();
      }
    }
  }

  private <T> T call(Work<T> work, long deadlineNs)
      throws DirectoryException, InterruptedException {
    boolean isRepeated = false;
    while (true) {
      Connection connection = null;
      try {
        connection = take(leftMs(deadlineNs));
        connection.setNetworkTimeout(Runnable::run, leftMs(deadlineNs));
        T result = work.on(connection, isRepeated);
        idle.push(new Idle(connection, System.nanoTime()));
        if (isClosed) {
          close();
        }
        return result;
      } catch (SQLException e) {
        isRepeated |= connection != null && mayHaveHappened(e);
        close(connection);
        if (!mayPass(e) || leftMs(deadlineNs) <= PAUSE_MS) {
          throw new DirectoryException(problem(e), e);
        }
        Thread.sleep(PAUSE_MS);
      }
    }
  }

  private static int leftMs(long deadlineNs) {
    return (int) Math.max(1, TimeUnit.NANOSECONDS.toMillis(deadlineNs - System.nanoTime()));
  }

  private Connection take(int leftMs) throws SQLException {
    for (Idle next = idle.poll(); next != null; next = idle.poll()) {
      boolean isFresh = System.nanoTime() - next.sinceNs < TimeUnit.MILLISECONDS.toNanos(FRESH_MS);
      if (isFresh || answers(next.connection, leftMs)) {
        return next.connection;
      }
      close(next.connection);
    }
    return open();
  }

  private static boolean answers(Connection connection, int leftMs) {
    try {
      connection.setNetworkTimeout(Runnable::run, Math.max(leftMs / 2, 1));
      try (PreparedStatement nothing = connection.prepareStatement("SELECT 1")) {
        return nothing.execute();
      }
    } catch (SQLException e) {
      return false;
    }
  }

  /** Opens a connection, and creates the tables if there are none. */
  Connection open() throws SQLException {
    Connection connection = new Driver().connect(address.jdbcUrl(), address.properties());
    try {
      if (!hasTables && !hasTables(connection)) {
        try (PreparedStatement create = connection.prepareStatement(TABLES)) {
          create.execute();
        }
      }
      hasTables = true;
      return connection;
    } catch (SQLException e) {
      close(connection);
      throw e;
    }
  }

  private static boolean hasTables(Connection connection) throws SQLException {
    try (PreparedStatement ask = connection.prepareStatement("SELECT to_regclass('carom.entry')");
        ResultSet found = ask.executeQuery()) {
      return found.next() && found.getString(1) != null;
    }
  }

  private static String state(SQLException e) {
    return e.getSQLState() == null ? "" : e.getSQLState();
  }

  /** Returns whether the connection broke, or the database stopped, before it answered. */
  private static boolean mayHaveHappened(SQLException e) {
    return state(e).startsWith("08") || state(e).startsWith("57P");
  }

  /** Returns whether another attempt may do: not if a right or a password is missing. */
  private static boolean mayPass(SQLException e) {
    return mayHaveHappened(e)
        || state(e).startsWith("40")
        || state(e).startsWith("53")
        || state(e).equals("57014")
        || state(e).equals("55P03")
        || state(e).equals("25006");
  }

  /** Returns what to tell the operator. */
  String problem(Exception e) {
    String said = Texts.clean(e.getMessage() + "");
    String hint = "";
    if (e instanceof SQLException sql) {
      hint =
          switch (state(sql)) {
            case "08001", "08006" -> "; check that it runs, and its address";
            case "28P01", "28000" -> "; check user and password (PGPASSFILE) and pg_hba.conf";
            case "3D000" -> "; create it: createdb";
            case "42501" -> "; the user needs CREATE on the database, or the tables of FLEET.md";
            case "57014" -> "; it takes more than " + address.deadlineMs() + " ms";
            default -> "";
          };
    }
    return "directory=" + address.shown() + " says: " + said + hint;
  }

  static void close(Connection connection) {
    try {
      if (connection != null) {
        connection.close();
      }
    } catch (SQLException e) {
      // it is of no use anyway
    }
  }

  /** Closes the connections that nobody uses, and others after their calls. */
  void close() {
    isClosed = true;
    for (Idle next = idle.poll(); next != null; next = idle.poll()) {
      close(next.connection);
    }
  }
}
