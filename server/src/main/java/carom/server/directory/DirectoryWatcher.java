package carom.server.directory;

/**
 * Hears of a directory's entries. The calls come one after the other, on a thread of the directory;
 * they must return at once.
 *
 * <p>A watcher learns where the directory has got to, not each step on the way: an entry that was
 * updated twice may be told once, and one that came and went may never be told. When the directory
 * was away for a while, it tells all that differs from what it has told before.
 */
public interface DirectoryWatcher {

  /** Tells of an entry that is new or has another value. */
  void present(DirectoryEntry entry);

  /**
   * Tells that an entry is gone: deleted, or its lease is over.
   *
   * @param last the entry as it was told last
   */
  void gone(DirectoryEntry last);

  /**
   * Tells that all entries there were when the watch began have been told, or that the directory
   * answers again and all changes since have been told.
   */
  void complete();
}
