package carom.server.directory;

/**
 * An entry of a {@link Directory}, as it was when it was read.
 *
 * @param key path such as {@code rooms/cup}
 * @param value text of at most {@value Directory#MAX_VALUE_BYTES} bytes of UTF-8
 * @param number number that {@link Directory#create} gave the entry; it stays through updates, and
 *     every later entry of the same key has a higher one
 * @param lease lease that holds the entry, or 0 for one that stays until it is deleted
 */
public record DirectoryEntry(String key, String value, long number, long lease) {}
