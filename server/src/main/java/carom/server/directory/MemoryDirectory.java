package carom.server.directory;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
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

  /** When a lease ends unless it is renewed. */
  private record LeaseEnd(long endNs, long lease) {}

  private final LongSupplier clock;
  private final TreeMap<String, DirectoryEntry> entries = new TreeMap<>();
  private final Map<Long, Lease> leases = new HashMap<>();
  private final PriorityQueue<LeaseEnd> ends =
      new PriorityQueue<>(Comparator.comparingLong(LeaseEnd::endNs));
  private final List<Door> doors = new ArrayList<>();
  private long lastNumber;

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
    while (!ends.isEmpty() && nowNs - ends.peek().endNs >= 0) {
      LeaseEnd due = ends.poll();
      Lease lease = leases.get(due.lease);
      if (lease != null && lease.endNs == due.endNs) { // it wasn't renewed
        end(due.lease);
      }
    }
  }

  private void end(long lease) {
    leases.remove(lease);
    List<String> gone = new ArrayList<>();
    for (DirectoryEntry entry : entries.values()) {
      if (entry.lease() == lease) {
        gone.add(entry.key());
      }
    }
    gone.forEach(entries::remove);
    gone.forEach(this::tell);
  }

  private void tell(String key) {
    new ArrayList<>(doors).forEach(door -> door.tell(key));
  }

  private void put(long lease, int ttlMs) {
    long endNs = clock.getAsLong() + ttlMs * NS_PER_MS;
    leases.put(lease, new Lease(ttlMs, endNs));
    ends.add(new LeaseEnd(endNs, lease));
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
        for (Watch watch : isAway ? List.<Watch>of() : new ArrayList<>(watches)) {
          watch.all(under(watch.prefix));
          watch.complete();
        }
      }
    }

    private void tell(String key) {
      for (Watch watch : isAway ? List.<Watch>of() : new ArrayList<>(watches)) {
        DirectoryEntry entry = entries.get(key); // a watcher may have changed it again
        if (key.startsWith(watch.prefix) && entry != null) {
          watch.present(entry);
        } else if (key.startsWith(watch.prefix)) {
          watch.gone(key);
        }
      }
    }

    private void begin() throws DirectoryException {
      if (isAway) {
        throw new DirectoryException("directory=memory is away", null);
      }
      tick();
    }

    @Override
    public long lease(int ttlMs) throws DirectoryException {
      EntryLimits.checkTtl(ttlMs);
      synchronized (MemoryDirectory.this) {
        begin();
        put(++lastNumber, ttlMs);
        return lastNumber;
      }
    }

    @Override
    public boolean renew(long lease) throws DirectoryException {
      synchronized (MemoryDirectory.this) {
        begin();
        Lease old = leases.get(lease);
        if (old != null) {
          put(lease, old.ttlMs);
        }
        return old != null;
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
        MemoryDirectory.this.tell(key);
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
        MemoryDirectory.this.tell(key);
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
        MemoryDirectory.this.tell(key);
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
