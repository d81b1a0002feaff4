package carom.server.fleet;

import carom.server.directory.Directory;
import carom.server.directory.DirectoryEntry;
import carom.server.directory.DirectoryWatcher;
import java.io.IOException;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The fleet as its directory has told it: servers, rooms, and rooms that have lost their owner.
 * What it says may be some milliseconds old. Any thread.
 */
final class FleetView {
  private static final Logger LOG = LoggerFactory.getLogger(FleetView.class);
  private static final long NS_PER_MS = 1_000_000;

  /** Most leases of servers whose processes are remembered. */
  private static final int MAX_BORN = 1_000;

  /** Time for which a room without an owner is remembered, ms. */
  private static final long ORPHAN_MS = 10_000;

  /**
   * A room whose claim is gone.
   *
   * @param record what its last owner told
   * @param claim the number of the last claim
   * @param sinceNs when it was heard
   */
  record Orphan(RoomRecord record, long claim, long sinceNs) {}

  /**
   * A room that a server owns.
   *
   * @param record what the owner told last
   * @param claim number of its claim
   */
  record OwnedRoom(RoomRecord record, long claim) {
    /** Returns whether a server must look now: what lists show changes often, and can wait. */
    private boolean differs(RoomRecord before) {
      return record.leaving() != before.leaving()
          || record.isBuilt() != before.isBuilt()
          || record.follower() != before.follower();
    }
  }

  private final LongSupplier clock;
  private final Runnable changed;
  private final FleetNews news;
  private final Map<Long, ServerRecord> servers = new ConcurrentSkipListMap<>();

  /**
   * The first lease of each server's process, by each of its leases: also of those gone, unless
   * they are dead.
   */
  private final ConcurrentSkipListMap<Long, Long> born = new ConcurrentSkipListMap<>();

  private final Map<String, OwnedRoom> rooms = new ConcurrentSkipListMap<>();
  private final Map<String, Orphan> orphans = new ConcurrentHashMap<>();

  /**
   * Creates a view that begins to listen.
   *
   * @param changed told after each change that can't wait for the next turn, on the directory's
   *     thread; returns at once
   * @param news told of servers that come and go
   */
  FleetView(Directory directory, LongSupplier clock, Runnable changed, FleetNews news) {
    this.clock = clock;
    this.changed = changed;
    this.news = news;
    directory.watch(ServerRecord.PREFIX, new ServerWatcher());
    directory.watch(RoomRecord.PREFIX, new RoomWatcher());
  }

  /** Returns the servers by lease. */
  Map<Long, ServerRecord> servers() {
    return servers;
  }

  /** Returns the name of a server, for people. */
  String nameOf(long lease) {
    ServerRecord server = servers.get(lease);
    return server == null ? "a server that is gone" : server.name();
  }

  /**
   * Returns the server whose process had a lease, which it may have lost: after a directory that
   * was away, all have new ones. Null if it isn't there.
   */
  ServerRecord having(long lease) {
    ServerRecord same = servers.get(lease);
    Long process = same == null ? born.get(lease) : null;
    if (process != null) {
      for (ServerRecord server : servers.values()) {
        same = server.born() == process ? server : same;
      }
    }
    return same;
  }

  /** Returns whether the process that had a lease may get another one, as far as is known. */
  boolean mayReturn(long lease) {
    return born.containsKey(lease);
  }

  /** Learns that the process that has a lease is dead, so that it never returns. */
  void bury(long lease) {
    born.remove(lease);
  }

  /**
   * Forgets what belongs to a lease that this server has revoked, before the directory says that it
   * is gone: the players of its rooms wait.
   */
  void revoked(long lease) {
    ServerRecord server = servers.remove(lease);
    if (server != null) {
      news.gone(server);
    }
    for (Map.Entry<String, OwnedRoom> room : rooms.entrySet()) {
      if (room.getValue().record().server() == lease) {
        lost(room.getKey());
      }
    }
  }

  private boolean lost(String room) {
    OwnedRoom before = rooms.remove(room);
    if (before != null) {
      orphans.put(room, new Orphan(before.record(), before.claim(), clock.getAsLong()));
    }
    return before != null;
  }

  /** Returns the rooms by name. */
  Map<String, OwnedRoom> rooms() {
    return rooms;
  }

  /** Returns the rooms that have lost their owner lately, by name. */
  Map<String, Orphan> orphans() {
    long nowNs = clock.getAsLong();
    orphans.values().removeIf(orphan -> nowNs - orphan.sinceNs > ORPHAN_MS * NS_PER_MS);
    return orphans;
  }

  private final class ServerWatcher implements DirectoryWatcher {
    @Override
    public void present(DirectoryEntry entry) {
      try {
        long lease = Long.parseLong(entry.key().substring(ServerRecord.PREFIX.length()));
        ServerRecord server = ServerRecord.parse(lease, entry.value());
        ServerRecord before = servers.put(lease, server);
        born.put(lease, server.born());
        if (born.size() > MAX_BORN) {
          born.pollFirstEntry(); // the oldest
        }
        if (before == null) {
          news.came(server);
        }
        if (before == null || before.draining() != server.draining()) {
          changed.run();
        }
      } catch (IOException | NumberFormatException e) {
        LOG.warn("fleet: the entry {} can't be read: {}", entry.key(), e.getMessage());
      }
    }

    @Override
    public void gone(DirectoryEntry last) {
      try {
        ServerRecord server =
            servers.remove(Long.parseLong(last.key().substring(ServerRecord.PREFIX.length())));
        if (server != null) {
          news.gone(server);
        }
      } catch (NumberFormatException e) {
        return; // it was never taken for a server
      }
      changed.run();
    }

    @Override
    public void complete() {
      changed.run();
    }
  }

  private final class RoomWatcher implements DirectoryWatcher {
    @Override
    public void present(DirectoryEntry entry) {
      String room = entry.key().substring(RoomRecord.PREFIX.length());
      try {
        OwnedRoom owned = new OwnedRoom(RoomRecord.parse(entry.value()), entry.number());
        OwnedRoom before = rooms.put(room, owned);
        orphans.remove(room);
        if (before == null || before.claim() != owned.claim() || owned.differs(before.record())) {
          changed.run();
        }
      } catch (IOException e) {
        LOG.warn("fleet: the entry {} can't be read: {}", entry.key(), e.getMessage());
      }
    }

    @Override
    public void gone(DirectoryEntry last) {
      String room = last.key().substring(RoomRecord.PREFIX.length());
      if (lost(room)) {
        changed.run();
      }
    }

    @Override
    public void complete() {
      changed.run();
    }
  }
}
