package carom.server.fleet;

import carom.server.directory.Directory;
import carom.server.directory.DirectoryEntry;
import carom.server.directory.DirectoryException;

/**
 * The rooms to which first members of parties go. Rooms tell which parties are in them a moment
 * later; until then an entry of the directory, which ends by itself, has all members go the same
 * way. Any thread.
 */
final class Parties {
  private static final String PREFIX = "parties/";

  /** Longer than a ticket is good, and than its player's room needs to tell of the party. */
  private static final int TTL_MS = 15_000;

  private final Directory directory;

  Parties(Directory directory) {
    this.directory = directory;
  }

  /**
   * Settles the room of a party, unless it is settled.
   *
   * @return the room where it is settled
   */
  String settle(String party, String room) throws DirectoryException {
    String key = PREFIX + party;
    DirectoryEntry settled = directory.get(key);
    if (settled == null && directory.create(key, room, directory.lease(TTL_MS)) == 0) {
      settled = directory.get(key); // another server was faster
    }
    return settled == null ? room : settled.value();
  }
}
