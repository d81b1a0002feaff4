package carom.lab.fleet;

import carom.server.directory.Directory;
import carom.server.directory.DirectoryEntry;
import carom.server.directory.DirectoryException;
import carom.server.directory.DirectoryWatcher;
import java.util.List;

/** A server's way to its directory, of which the traffic is counted. */
final class MeteredDirectory implements Directory {
  final DirectoryTraffic traffic = new DirectoryTraffic();
  private final Directory directory;

  MeteredDirectory(Directory directory) {
    this.directory = directory;
  }

  private void other(String key, String value) {
    traffic.others++;
    traffic.bytes += key.length() + value.length();
  }

  @Override
  public long lease(int ttlMs) throws DirectoryException {
    other("", "");
    return directory.lease(ttlMs);
  }

  @Override
  public boolean renew(long lease) throws DirectoryException {
    traffic.renewals++;
    return directory.renew(lease);
  }

  @Override
  public void revoke(long lease) throws DirectoryException {
    other("", "");
    directory.revoke(lease);
  }

  @Override
  public long create(String key, String value, long lease) throws DirectoryException {
    other(key, value);
    return directory.create(key, value, lease);
  }

  @Override
  public Succession succeed(String key, String value, long lease, String note)
      throws DirectoryException {
    traffic.claims++;
    traffic.bytes += key.length() + value.length() + note.length();
    return directory.succeed(key, value, lease, note);
  }

  @Override
  public boolean update(String key, String value, long number) throws DirectoryException {
    traffic.updates++;
    traffic.bytes += key.length() + value.length();
    return directory.update(key, value, number);
  }

  @Override
  public boolean delete(String key, long number) throws DirectoryException {
    other(key, "");
    return directory.delete(key, number);
  }

  @Override
  public DirectoryEntry get(String key) throws DirectoryException {
    other(key, "");
    return directory.get(key);
  }

  @Override
  public List<DirectoryEntry> list(String prefix) throws DirectoryException {
    other(prefix, "");
    return directory.list(prefix);
  }

  @Override
  public void watch(String prefix, DirectoryWatcher watcher) {
    directory.watch(
        prefix,
        new DirectoryWatcher() {
          @Override
          public void present(DirectoryEntry entry) {
            traffic.events++;
            traffic.eventBytes += entry.key().length() + entry.value().length();
            watcher.present(entry);
          }

          @Override
          public void gone(DirectoryEntry last) {
            traffic.events++;
            traffic.eventBytes += last.key().length();
            watcher.gone(last);
          }

          @Override
          public void complete() {
            watcher.complete();
          }
        });
  }

  @Override
  public void close() {
    directory.close();
  }
}
