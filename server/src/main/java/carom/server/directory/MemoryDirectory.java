package carom.server.directory;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.LongSupplier;

/**
 * A directory in this process, by a clock that the caller hands in: for tests and for fleets in
 * virtual time. Each server has a {@link Door} of its own, which can be cut off. Watchers are told
 * within the call that changes an entry, and in {@link #tick} of leases that ended. Any thread.
 */
public final class MemoryDirectory {
  private static final long NS_PER_MS = 1_000_000;

  private record Lease(int ttlMs, long endNs) {}

  private final LongSupplier clock;
  private final TreeMap<String, DirectoryEntry> entries = new TreeMap<>();
  private final Map<Long, Lease> leases = new HashMap<>();
  private final List<Door> doors = new ArrayList<>();
  private long lastNumber;
  private long calls;

  /**
   * Creates an empty directory.
   *
   * @param clock monotonic nanoseconds, real or virtual
   */
  public MemoryDirectory(LongSupplier clock) {
    this.clock = clock;
  }

  /** Returns a new way to this directory, for one server. */
  public synchronized Door door() {
    Door door = new Door();
    doors.add(door);
    return door;
  }

  /** Ends the leases whose time is over. */
  public synchronized void tick() {
    long nowNs = clock.getAsLong();
    for (long lease : new ArrayList<>(leases.keySet())) {
      if (nowNs - leases.get(lease).endNs >= 0) {
        end(lease);
      }
    }
  }

  /** Returns the number of calls so far that were answered. */
  public synchronized long calls() {
    return calls;
  }

  private void end(long lease) {
    leases.remove(lease);
    entries.values().removeIf(entry -> entry.lease() == lease);
    tell();
  }

  private void tell() {
    new ArrayList<>(doors).forEach(Door::tell);
  }

  private List<DirectoryEntry> under(String prefix) {
    return entries.tailMap(prefix).values().stream()
        .takeWhile(entry -> entry.key().startsWith(prefix))
        .toList();
  }

  /** One server's way to the directory. */
  public final class Door implements Directory {
    private final List<Watch> watches = new ArrayList<>();
    private boolean isAway;

    private Door() {}

    /** Makes every call of this door fail from now on, and tells it nothing; or ends that. */
    public void away(boolean nowAway) {
      synchronized (MemoryDirectory.this) {
        isAway = nowAway;
        tell();
        if (!isAway) {
          new ArrayList<>(watches).forEach(Watch::complete);
        }
      }
    }

    private void tell() {
      if (!isAway) {
        new ArrayList<>(watches).forEach(watch -> watch.all(under(watch.prefix)));
      }
    }

    private void begin() throws DirectoryException {
      if (isAway) {
        throw new DirectoryException("directory=memory is away", null);
      }
      calls++;
      tick();
    }

    @Override
    public long lease(int ttlMs) throws DirectoryException {
      EntryLimits.checkTtl(ttlMs);
      synchronized (MemoryDirectory.this) {
        begin();
        leases.put(++lastNumber, new Lease(ttlMs, clock.getAsLong() + ttlMs * NS_PER_MS));
        return lastNumber;
      }
    }

    @Override
    public boolean renew(long lease) throws DirectoryException {
      synchronized (MemoryDirectory.this) {
        begin();
        long nowNs = clock.getAsLong();
        Lease renewed =
            leases.computeIfPresent(
                lease, (number, old) -> new Lease(old.ttlMs, nowNs + old.ttlMs * NS_PER_MS));
        return renewed != null;
      }
    }

    @Override
    public void revoke(long lease) throws DirectoryException {
      synchronized (MemoryDirectory.this) {
        begin();
        end(lease);
      }
    }

    @Override
    public long create(String key, String value, long lease) throws DirectoryException {
      EntryLimits.checkKey(key);
      EntryLimits.checkValue(value);
      synchronized (MemoryDirectory.this) {
        begin();
        if (entries.containsKey(key) || (lease != 0 && !leases.containsKey(lease))) {
          return 0;
        }
        long number = ++lastNumber;
        entries.put(key, new DirectoryEntry(key, value, number, lease));
        MemoryDirectory.this.tell();
        return number;
      }
    }

    @Override
    public Succession succeed(String key, String value, long lease, String note)
        throws DirectoryException {
      EntryLimits.checkKey(note);
      synchronized (MemoryDirectory.this) {
        long number = create(key, value, lease);
        if (number == 0) {
          return new Succession(0, 0);
        }
        DirectoryEntry before = entries.put(note, new DirectoryEntry(note, "", number, 0));
        return new Succession(number, before == null ? 0 : before.number());
      }
    }

    @Override
    public boolean update(String key, String value, long number) throws DirectoryException {
      EntryLimits.checkKey(key);
      EntryLimits.checkValue(value);
      synchronized (MemoryDirectory.this) {
        begin();
        DirectoryEntry entry = entries.get(key);
        if (entry == null || entry.number() != number) {
          return false;
        }
        entries.put(key, new DirectoryEntry(key, value, number, entry.lease()));
        MemoryDirectory.this.tell();
        return true;
      }
    }

    @Override
    public boolean delete(String key, long number) throws DirectoryException {
      EntryLimits.checkKey(key);
      synchronized (MemoryDirectory.this) {
        begin();
        DirectoryEntry entry = entries.get(key);
        if (entry == null || entry.number() != number) {
          return false;
        }
        entries.remove(key);
        MemoryDirectory.this.tell();
        return true;
      }
    }

    @Override
    public DirectoryEntry get(String key) throws DirectoryException {
      EntryLimits.checkKey(key);
      synchronized (MemoryDirectory.this) {
        begin();
        return entries.get(key);
      }
    }

    @Override
    public List<DirectoryEntry> list(String prefix) throws DirectoryException {
      EntryLimits.checkPrefix(prefix);
      synchronized (MemoryDirectory.this) {
        begin();
        return under(prefix);
      }
    }

    @Override
    public void watch(String prefix, DirectoryWatcher watcher) {
      EntryLimits.checkPrefix(prefix);
      synchronized (MemoryDirectory.this) {
        Watch watch = new Watch(prefix, watcher);
        watches.add(watch);
        if (!isAway) {
          watch.all(under(prefix));
          watch.complete();
        }
      }
    }

    @Override
    public void close() {
      synchronized (MemoryDirectory.this) {
        watches.clear();
        doors.remove(this);
      }
    }
  }
}
