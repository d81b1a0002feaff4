package carom.server.directory;

import java.sql.Connection;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.postgresql.PGConnection;
import org.postgresql.PGNotification;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The watches of a directory in PostgreSQL: one thread with a connection that is notified of keys
 * that changed, and reads them. It also looks for leases that ended. When the connection breaks, it
 * reads all anew.
 */
final class PostgresWatches implements Runnable {
  private static final Logger LOG = LoggerFactory.getLogger(PostgresWatches.class);
  private static final int WAIT_MS = 50;
  private static final int LOOK_MS = 250;
  private static final int PAUSE_MS = 100;

  private final PostgresConnections connections;
  private final List<Watch> watches = new CopyOnWriteArrayList<>();
  private Thread thread;
  private volatile boolean isClosed;
  private boolean isProblemTold;

  PostgresWatches(PostgresConnections connections) {
    this.connections = connections;
  }

  /** Begins a watch. */
  synchronized void add(Watch watch) {
    watches.add(watch);
    if (thread == null && !isClosed) {
      thread = new Thread(this, "carom-directory-watch");
      thread.setDaemon(true);
      thread.start();
    }
  }

  synchronized void close() {
    isClosed = true;
    if (thread != null) {
      thread.interrupt();
    }
  }

  @Override
  public void run() {
    while (!isClosed) {
      Connection connection = null;
      try {
        connection = connections.open();
        follow(connection);
      } catch (SQLException | RuntimeException e) {
        failed(e);
      } finally {
        PostgresConnections.close(connection);
      }
    }
  }

  private void failed(Exception e) {
    if (isClosed) {
      return;
    }
    if (!isProblemTold) {
      LOG.warn("{}; trying on", connections.problem(e));
      isProblemTold = true;
    }
    try {
      Thread.sleep(PAUSE_MS);
    } catch (InterruptedException interrupted) {
      isClosed = true;
    }
  }

  private void follow(Connection connection) throws SQLException {
    connection.setNetworkTimeout(Runnable::run, Directory.DEADLINE_MS);
    try (Statement listen = connection.createStatement()) {
      listen.execute("LISTEN carom");
    }
    PGConnection notified = connection.unwrap(PGConnection.class);
    int told = 0; // watches that know all, the first ones
    long lookNs = System.nanoTime();
    while (!isClosed) {
      for (; told < watches.size() && !isClosed; told++) {
        Watch watch = watches.get(told);
        watch.all(PostgresDirectory.all(connection, watch.prefix));
        watch.complete();
        if (isProblemTold) {
          LOG.info("directory: PostgreSQL answers again");
          isProblemTold = false;
        }
      }
      PGNotification[] notifications = notified.getNotifications(WAIT_MS);
      if (notifications != null && notifications.length > 0) {
        tell(
            connection,
            told,
            Stream.of(notifications).map(PGNotification::getParameter).distinct().toList());
      }
      if (System.nanoTime() - lookNs >= TimeUnit.MILLISECONDS.toNanos(LOOK_MS)) {
        lookNs = System.nanoTime();
        if (PostgresDirectory.run(connection, PostgresDirectory.HAS_PAST)) {
          PostgresDirectory.run(connection, PostgresDirectory.END_PAST);
        }
      }
    }
  }

  private void tell(Connection connection, int told, List<String> keys) throws SQLException {
    Map<String, DirectoryEntry> now =
        PostgresDirectory.some(connection, keys).stream()
            .collect(Collectors.toMap(DirectoryEntry::key, Function.identity()));
    for (int i = 0; i < told; i++) {
      Watch watch = watches.get(i);
      for (String key : keys) {
        if (isClosed || !key.startsWith(watch.prefix)) {
          continue;
        }
        DirectoryEntry entry = now.get(key);
        if (entry == null) {
          watch.gone(key);
        } else {
          watch.present(entry);
        }
      }
    }
  }
}
