package carom.server.directory;

import java.util.List;

/**
 * Keeps small entries for a fleet of servers: who is there, and who owns which room. Any thread.
 *
 * <p><b>Leases.</b> An entry may be held by a lease. It goes when the lease ends, because nobody
 * renewed it in time or because it was revoked. A lease that has ended never comes back, even if
 * its owner does: another one has another number.
 *
 * <p><b>Numbers.</b> Each {@link #create} gives its entry a number higher than any before. It
 * <em>fences</em>: a server that was frozen and whose room another server owns now has an older
 * number. Its updates are refused here, and its words by each client that knows the newer number.
 *
 * <p><b>Order.</b> All calls take effect one after the other, in the same order for everybody (they
 * are linearizable). Watchers hear of it later.
 *
 * <p>Each call waits for the answer, at most {@value #DEADLINE_MS} ms, and throws a {@link
 * DirectoryException} without one. Then it may have happened or not; {@link #get} tells.
 */
public interface Directory extends AutoCloseable {
  /** Longest value of an entry, bytes of UTF-8. */
  int MAX_VALUE_BYTES = 16_384;

  /** Longest key, characters. A key has letters, digits, {@code - _ . /} and other characters. */
  int MAX_KEY_CHARS = 256;

  /** Longest time that a call takes, ms. */
  int DEADLINE_MS = 1_000;

  /**
   * Begins a lease.
   *
   * @param ttlMs time after which it ends if it isn't renewed, 1,000..600,000 ms; a directory may
   *     round it up to whole seconds
   * @return its number, above 0, which no other lease ever has
   */
  long lease(int ttlMs) throws DirectoryException;

  /**
   * Renews a lease for its whole time from now on.
   *
   * @return false if it has ended, for ever
   */
  boolean renew(long lease) throws DirectoryException;

  /** Ends a lease, one's own or another's, and removes its entries. */
  void revoke(long lease) throws DirectoryException;

  /**
   * Creates an entry, unless there is one of this key.
   *
   * @param lease what holds it, or 0 for an entry that stays until it is deleted
   * @return the entry's number, above 0; 0 if there is one of this key, or the lease has ended
   */
  long create(String key, String value, long lease) throws DirectoryException;

  /**
   * The numbers of an entry and of the one before.
   *
   * @param number of the new entry, above 0; 0 if there is none, as with {@link #create}
   * @param before number of the last entry that this note was made for, 0 for none
   */
  record Succession(long number, long before) {}

  /**
   * Creates an entry as {@link #create} does, and with it notes its number for ever.
   *
   * @param note key of the note, which only this method writes
   */
  Succession succeed(String key, String value, long lease, String note) throws DirectoryException;

  /**
   * Gives an entry another value.
   *
   * @param number as {@link #create} returned it
   * @return false if that entry is gone; nothing has changed then
   */
  boolean update(String key, String value, long number) throws DirectoryException;

  /**
   * Deletes an entry.
   *
   * @param number as {@link #create} returned it
   * @return whether this call has deleted it; of several callers one is told true
   */
  boolean delete(String key, long number) throws DirectoryException;

  /** Returns the entry of a key, or null. */
  DirectoryEntry get(String key) throws DirectoryException;

  /** Returns all entries whose keys begin with a prefix, by key. */
  List<DirectoryEntry> list(String prefix) throws DirectoryException;

  /**
   * Tells a watcher of all entries whose keys begin with a prefix, now and whenever they change,
   * until the directory is closed. While the directory doesn't answer, nothing is told.
   */
  void watch(String prefix, DirectoryWatcher watcher);

  /** Ends all watches. Leases end by themselves. */
  @Override
  void close();
}
