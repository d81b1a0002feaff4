package carom.server.fleet;

import carom.server.directory.Directory;
import carom.server.directory.DirectoryEntry;
import carom.server.directory.DirectoryException;
import carom.server.directory.DirectoryWatcher;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;

/** Counts what is asked of a directory, and what fails. Any thread. */
final class CountedDirectory implements Directory {
  private final Directory directory;
  private final AtomicLong requests = new AtomicLong();
  private final AtomicLong failures = new AtomicLong();
  private volatile boolean up = true;

  CountedDirectory(Directory directory) {
    this.directory = directory;
  }

  /** Returns the number of requests. */
  long requests() {
    return requests.get();
  }

  /** Returns the number of requests without an answer. */
  long failures() {
    return failures.get();
  }

  /** Returns whether the last request was answered. */
  boolean isUp() {
    return up;
  }

  /** Asks the directory for something. */
  private interface Request<T> {
    T answer() throws DirectoryException;
  }

  private <T> T count(Request<T> request) throws DirectoryException {
    requests.incrementAndGet();
    try {
      T answer = request.answer();
      up = true;
      return answer;
    } catch (DirectoryException e) {
      failures.incrementAndGet();
      up = false;
      throw e;
    }
  }

  @Override
  public long lease(int ttlMs) throws DirectoryException {
    return count(() -> directory.lease(ttlMs));
  }

  @Override
  public boolean renew(long lease) throws DirectoryException {
    return count(() -> directory.renew(lease));
  }

  @Override
  public void revoke(long lease) throws DirectoryException {
    count(
        () -> {
          directory.revoke(lease);
          return null;
        });
  }

  @Override
  public long create(String key, String value, long lease) throws DirectoryException {
    return count(() -> directory.create(key, value, lease));
  }

  @Override
  public Succession succeed(String key, String value, long lease, String note)
      throws DirectoryException {
    return count(() -> directory.succeed(key, value, lease, note));
  }

  @Override
  public boolean update(String key, String value, long number) throws DirectoryException {
    return count(() -> directory.update(key, value, number));
  }

  @Override
  public boolean delete(String key, long number) throws DirectoryException {
    return count(() -> directory.delete(key, number));
  }

  @Override
  public DirectoryEntry get(String key) throws DirectoryException {
    return count(() -> directory.get(key));
  }

  @Override
  public List<DirectoryEntry> list(String prefix) throws DirectoryException {
    return count(() -> directory.list(prefix));
  }

  @Override
  public void watch(String prefix, DirectoryWatcher watcher) {
    directory.watch(prefix, watcher);
  }

  @Override
  public void close() {
    directory.close();
  }
}
