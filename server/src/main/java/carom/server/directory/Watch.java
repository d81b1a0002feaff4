package carom.server.directory;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;

/** One watcher, and what it has been told. One thread at a time. */
final class Watch {
  final String prefix;

  private final DirectoryWatcher watcher;
  private final TreeMap<String, DirectoryEntry> told = new TreeMap<>();

  Watch(String prefix, DirectoryWatcher watcher) {
    this.prefix = prefix;
    this.watcher = watcher;
  }

  /** Tells all that differs from what it has told before. */
  void all(List<DirectoryEntry> entries) {
    TreeMap<String, DirectoryEntry> now = new TreeMap<>();
    entries.forEach(entry -> now.put(entry.key(), entry));
    for (DirectoryEntry last : new ArrayList<>(told.values())) {
      DirectoryEntry entry = now.get(last.key());
      if (entry == null || entry.number() != last.number()) {
        gone(last.key());
      }
    }
    entries.forEach(this::present);
  }

  /** Tells of an entry, and that an older one of its key is gone. */
  void present(DirectoryEntry entry) {
    DirectoryEntry last = told.get(entry.key());
    if (last != null && last.number() != entry.number()) {
      gone(entry.key());
    }
    if (!entry.equals(last)) {
      told.put(entry.key(), entry);
      watcher.present(entry);
    }
  }

  /** Tells that the entry of a key is gone, if it has told of one. */
  void gone(String key) {
    DirectoryEntry last = told.remove(key);
    if (last != null) {
      watcher.gone(last);
    }
  }

  /** Tells that the watcher knows all. */
  void complete() {
    watcher.complete();
  }
}
