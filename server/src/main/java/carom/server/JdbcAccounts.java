package carom.server;

import carom.server.account.AccountStore;
import carom.server.account.AccountValues;
import carom.server.account.AccountWrite;
import carom.server.account.Stay;
import carom.server.directory.DirectoryTls;
import carom.server.directory.PostgresAddress;
import carom.text.FileErrors;
import carom.text.Texts;
import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermissions;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;
import org.postgresql.Driver;

/**
 * Accounts in a database: two tables of the schema {@code carom}, which it creates if they aren't
 * there. The same SQL serves H2, a file beside the server, and PostgreSQL, for several servers. A
 * connection that fails is closed; the next call opens another. One thread.
 */
public final class JdbcAccounts implements AccountStore {
  /** Longest time of a call of PostgreSQL, ms. */
  private static final int DEADLINE_MS = 2_000;

  private static final List<String> TABLES =
      List.of(
          "CREATE SCHEMA IF NOT EXISTS carom",
          """
          CREATE TABLE IF NOT EXISTS carom.account (
            account varchar(64) PRIMARY KEY, issued bigint NOT NULL, stamp bigint NOT NULL,
            playing boolean NOT NULL, name varchar(64) NOT NULL)
          """,
          """
          CREATE TABLE IF NOT EXISTS carom.kept (
            account varchar(64) NOT NULL, game varchar(255) NOT NULL, field varchar(64) NOT NULL,
            form varchar(16384) NOT NULL, word integer NOT NULL, room varchar(255) NOT NULL,
            match_number integer NOT NULL, tick integer NOT NULL,
            changed timestamp with time zone NOT NULL, PRIMARY KEY (account, game, field))
          """,
          "CREATE INDEX IF NOT EXISTS kept_best ON carom.kept (game, field, word)");

  /** Opens connections. */
  private interface Opener {
    Connection open() throws SQLException, IOException;
  }

  /** Work that is a transaction. */
  private interface Work<T> {
    T on(Connection connection) throws SQLException;
  }

  private final String title;
  private final Opener opener;
  private Connection connection;

  private JdbcAccounts(String title, Opener opener) {
    this.title = title;
    this.opener = opener;
  }

  /**
   * Returns accounts in a file of H2, which nobody else may use meanwhile.
   *
   * @param file without the ending {@code .mv.db}
   * @throws IOException if its path can't be used
   */
  public static JdbcAccounts file(Path file) throws IOException {
    String path = file.toAbsolutePath().toString();
    if (path.indexOf(';') >= 0) {
      throw new IOException("data=" + path + " has a \";\", which the database takes for its own");
    }
    // Without a delay, a commit is with the operating system before anything counts as stored.
    String url = "jdbc:h2:file:" + path + ";WRITE_DELAY=0;DB_CLOSE_ON_EXIT=FALSE";
    Path stored = file.resolveSibling(file.getFileName() + ".mv.db");
    return new JdbcAccounts(
        stored.toString(),
        () -> {
          createForOwner(stored);
          return new org.h2.Driver().connect(url, new Properties());
        });
  }

  /** Creates an empty file that its owner alone may read, unless it is there. */
  private static void createForOwner(Path file) throws IOException {
    boolean posix = file.getFileSystem().supportedFileAttributeViews().contains("posix");
    FileAttribute<?>[] owner =
        posix
            ? new FileAttribute<?>[] {
              PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------"))
            }
            : new FileAttribute<?>[0];
    try {
      Files.createFile(file, owner);
    } catch (FileAlreadyExistsException e) {
      // as it should be
    } catch (IOException e) {
      throw new IOException(file + " can't be written: " + FileErrors.reason(e), e);
    }
  }

  /**
   * Returns accounts in a PostgreSQL. Nothing is sent before the first call.
   *
   * @param address as {@code --fleet} has it
   * @throws IOException if it is none; doesn't repeat it, because of the password
   */
  public static JdbcAccounts postgres(String address) throws IOException {
    PostgresAddress to = PostgresAddress.parse("--store", address, DirectoryTls.NONE, DEADLINE_MS);
    return new JdbcAccounts(to.shown(), () -> new Driver().connect(to.jdbcUrl(), to.properties()));
  }

  @Override
  public String title() {
    return title;
  }

  @Override
  public void open() throws IOException {
    transaction(c -> null);
  }

  @Override
  public Stay begin(String account, long known, boolean takesOver) throws IOException {
    return transaction(c -> begin(c, account, known, takesOver));
  }

  private static Stay begin(Connection c, String account, long known, boolean takesOver)
      throws SQLException {
    long issued = 0;
    long stamp = 0;
    boolean isThere = false;
    boolean playing = false;
    try (PreparedStatement ask =
        c.prepareStatement(
            "SELECT issued, stamp, playing FROM carom.account WHERE account = ? FOR UPDATE")) {
      ask.setString(1, account);
      try (ResultSet found = ask.executeQuery()) {
        if (found.next()) {
          isThere = true;
          issued = found.getLong(1);
          stamp = found.getLong(2);
          playing = found.getBoolean(3);
        }
      }
    }
    boolean isElsewhere = known == 0 || stamp > known;
    if (playing && isElsewhere && !takesOver) {
      return null;
    }
    long next = Stay.nextJoin(Math.max(Math.max(issued, stamp), known));
    String change =
        isThere
            ? "UPDATE carom.account SET issued = ?, playing = TRUE WHERE account = ?"
            : "INSERT INTO carom.account (issued, account, stamp, playing, name)"
                + " VALUES (?, ?, 0, TRUE, '')";
    try (PreparedStatement put = c.prepareStatement(change)) {
      put.setLong(1, next);
      put.setString(2, account);
      put.executeUpdate();
    }
    if (!isElsewhere) {
      return new Stay(account, next, null);
    }
    Map<String, Map<String, AccountValues.Kept>> games = new TreeMap<>();
    try (PreparedStatement ask =
        c.prepareStatement("SELECT game, field, form, word FROM carom.kept WHERE account = ?")) {
      ask.setString(1, account);
      try (ResultSet found = ask.executeQuery()) {
        while (found.next()) {
          games
              .computeIfAbsent(found.getString(1), game -> new TreeMap<>())
              .put(found.getString(2), new AccountValues.Kept(found.getString(3), found.getInt(4)));
        }
      }
    }
    return new Stay(account, next, new AccountValues(games));
  }

  @Override
  public boolean write(AccountWrite write) throws IOException {
    return transaction(c -> write(c, write));
  }

  private static boolean write(Connection c, AccountWrite w) throws SQLException {
    if (!raise(c, w)) {
      return false;
    }
    for (Map.Entry<String, AccountValues.Kept> value : w.values().entrySet()) {
      put(c, w, value.getKey(), value.getValue());
    }
    if (w.isLast()) { // of players who have gained nothing, nothing stays
      try (PreparedStatement clear =
          c.prepareStatement(
              "DELETE FROM carom.account a WHERE a.account = ? AND a.issued <= ? AND NOT EXISTS"
                  + " (SELECT 1 FROM carom.kept k WHERE k.account = a.account)")) {
        clear.setString(1, w.account());
        clear.setLong(2, w.stamp());
        clear.executeUpdate();
      }
    }
    return true;
  }

  /** Lets no older stay write from now on; returns false if a newer one has written. */
  private static boolean raise(Connection c, AccountWrite w) throws SQLException {
    try (PreparedStatement put =
        c.prepareStatement(
            "UPDATE carom.account SET stamp = ?, name = ?,"
                + " playing = CASE WHEN issued <= ? THEN ? ELSE playing END"
                + " WHERE account = ? AND stamp <= ?")) {
      put.setLong(1, w.stamp());
      put.setString(2, w.name());
      put.setLong(3, w.stamp());
      put.setBoolean(4, !w.isLast());
      put.setString(5, w.account());
      put.setLong(6, w.stamp());
      if (put.executeUpdate() > 0) {
        return true;
      }
    }
    try (PreparedStatement put =
        c.prepareStatement(
            "INSERT INTO carom.account (account, issued, stamp, playing, name)"
                + " SELECT ?, ?, ?, ?, ? WHERE NOT EXISTS"
                + " (SELECT 1 FROM carom.account WHERE account = ?)")) {
      put.setString(1, w.account());
      put.setLong(2, w.stamp());
      put.setLong(3, w.stamp());
      put.setBoolean(4, !w.isLast());
      put.setString(5, w.name());
      put.setString(6, w.account());
      return put.executeUpdate() > 0;
    }
  }

  private static void put(Connection c, AccountWrite w, String field, AccountValues.Kept value)
      throws SQLException {
    String update =
        "UPDATE carom.kept SET form = ?, word = ?, room = ?, match_number = ?, tick = ?,"
            + " changed = CASE WHEN word = ? THEN changed ELSE CURRENT_TIMESTAMP END"
            + " WHERE account = ? AND game = ? AND field = ?";
    String insert =
        "INSERT INTO carom.kept (form, word, room, match_number, tick, changed, account, game,"
            + " field) VALUES (?, ?, ?, ?, ?, CURRENT_TIMESTAMP, ?, ?, ?)";
    for (String way : new String[] {update, insert}) {
      try (PreparedStatement put = c.prepareStatement(way)) {
        put.setString(1, value.form());
        put.setInt(2, value.word());
        put.setString(3, w.place().room());
        put.setInt(4, w.place().match());
        put.setInt(5, w.place().tick());
        int next = 6;
        if (way.equals(update)) {
          put.setInt(next++, value.word());
        }
        put.setString(next++, w.account());
        put.setString(next++, w.game());
        put.setString(next, field);
        if (put.executeUpdate() > 0) {
          return;
        }
      }
    }
  }

  @Override
  public List<Row> best(String game, String field, boolean lowest, int start, int most)
      throws IOException {
    String order = lowest ? "k.word" : "k.word DESC";
    return transaction(
        c -> {
          try (PreparedStatement ask =
              c.prepareStatement(
                  "SELECT a.account, a.name, k.word FROM carom.kept k JOIN carom.account a"
                      + " ON a.account = k.account WHERE k.game = ? AND k.field = ?"
                      + " AND k.word <> ? ORDER BY "
                      + order
                      + ", k.changed LIMIT ?")) {
            ask.setString(1, game);
            ask.setString(2, field);
            ask.setInt(3, start);
            ask.setInt(4, most);
            List<Row> rows = new ArrayList<>();
            try (ResultSet found = ask.executeQuery()) {
              while (found.next()) {
                rows.add(new Row(found.getString(1), found.getString(2), found.getInt(3)));
              }
            }
            return rows;
          }
        });
  }

  @Override
  public List<Known> find(String who, int most) throws IOException {
    return transaction(
        c -> {
          try (PreparedStatement ask =
              c.prepareStatement(
                  "SELECT account, name FROM carom.account WHERE account = ?"
                      + " OR LOWER(name) = LOWER(?) ORDER BY account LIMIT ?")) {
            ask.setString(1, who);
            ask.setString(2, who);
            ask.setInt(3, most);
            List<Known> all = new ArrayList<>();
            try (ResultSet found = ask.executeQuery()) {
              while (found.next()) {
                String account = found.getString(1);
                all.add(new Known(account, found.getString(2), valuesOf(c, account)));
              }
            }
            return all;
          }
        });
  }

  @Override
  public List<KnownValue> valuesOf(String account) throws IOException {
    return transaction(c -> valuesOf(c, account));
  }

  private static List<KnownValue> valuesOf(Connection c, String account) throws SQLException {
    try (PreparedStatement ask =
        c.prepareStatement(
            "SELECT game, field, form, word, room, match_number, tick FROM carom.kept"
                + " WHERE account = ? ORDER BY game, field")) {
      ask.setString(1, account);
      List<KnownValue> values = new ArrayList<>();
      try (ResultSet found = ask.executeQuery()) {
        while (found.next()) {
          values.add(
              new KnownValue(
                  found.getString(1),
                  found.getString(2),
                  new AccountValues.Kept(found.getString(3), found.getInt(4)),
                  new AccountWrite.Place(found.getString(5), found.getInt(6), found.getInt(7))));
        }
      }
      return values;
    }
  }

  @Override
  public long forget(String account, long known) throws IOException {
    return transaction(
        c -> {
          long newest = known;
          try (PreparedStatement ask =
              c.prepareStatement(
                  "SELECT issued, stamp FROM carom.account WHERE account = ? FOR UPDATE")) {
            ask.setString(1, account);
            try (ResultSet found = ask.executeQuery()) {
              if (!found.next()) {
                return 0L;
              }
              newest = Math.max(newest, Math.max(found.getLong(1), found.getLong(2)));
            }
          }
          long next = Stay.nextJoin(newest);
          try (PreparedStatement clear =
                  c.prepareStatement("DELETE FROM carom.kept WHERE account = ?");
              PreparedStatement put =
                  c.prepareStatement(
                      "UPDATE carom.account SET issued = ?, stamp = ?, playing = FALSE, name = ''"
                          + " WHERE account = ?")) {
            clear.setString(1, account);
            clear.executeUpdate();
            put.setLong(1, next);
            put.setLong(2, next);
            put.setString(3, account);
            put.executeUpdate();
          }
          return next;
        });
  }

  private <T> T transaction(Work<T> work) throws IOException {
    try {
      if (connection == null) {
        connection = connect();
      }
      T result = work.on(connection);
      connection.commit();
      return result;
    } catch (SQLException e) {
      close();
      String said = title + " says: " + Texts.clean(e.getMessage() + "");
      if (e.getSQLState() != null && e.getSQLState().startsWith("22")) {
        throw new IllegalArgumentException(said, e); // such as a text that is too long
      }
      throw new IOException(said, e);
    }
  }

  private Connection connect() throws SQLException, IOException {
    Connection opened = opener.open();
    try (Statement make = opened.createStatement()) {
      for (String table : TABLES) {
        make.execute(table);
      }
      opened.setAutoCommit(false);
      return opened;
    } catch (SQLException e) {
      close(opened);
      throw e;
    }
  }

  @Override
  public void close() {
    close(connection);
    connection = null;
  }

  private static void close(Connection connection) {
    try {
      if (connection != null) {
        connection.close();
      }
    } catch (SQLException e) {
      // it is of no use anyway
    }
  }
}
