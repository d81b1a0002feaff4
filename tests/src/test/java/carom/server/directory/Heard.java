package carom.server.directory;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** A watcher that remembers what it heard, and what can't be. */
final class Heard implements DirectoryWatcher {
  private final TreeMap<String, DirectoryEntry> entries = new TreeMap<>();
  private final List<String> wrong = new ArrayList<>();
  private int completes;

  @Override
  public synchronized void present(DirectoryEntry entry) {
    DirectoryEntry last = entries.put(entry.key(), entry);
    if (last != null && (last.number() != entry.number() || last.equals(entry))) {
      wrong.add(last + " was followed by " + entry);
    }
  }

  @Override
  public synchronized void gone(DirectoryEntry last) {
    if (!last.equals(entries.remove(last.key()))) {
      wrong.add("gone, though it wasn't told: " + last);
    }
  }

  @Override
  public synchronized void complete() {
    completes++;
  }

  synchronized int completes() {
    return completes;
  }

  synchronized Map<String, DirectoryEntry> entries() {
    return new TreeMap<>(entries);
  }

  synchronized DirectoryEntry entry(String key) {
    return entries.get(key);
  }

  synchronized long number(String key) {
    return entries.get(key).number();
  }

  synchronized Map<String, String> values() {
    TreeMap<String, String> values = new TreeMap<>();
    entries.forEach((key, entry) -> values.put(key, entry.value()));
    return values;
  }

  /** Fails if it heard what can't be. */
  synchronized void check() {
    if (!wrong.isEmpty()) {
      throw new AssertionError(wrong.toString());
    }
  }
}
