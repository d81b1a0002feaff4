package carom.server.access;

import carom.net.protocol.PlayerName;
import carom.server.command.Quoting;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * One line of a list: {@code name "Bob B" until 2026-12-01T00:00:00Z because of threats}.
 * Immutable. It is about addresses, a name or an account; what it isn't about is null.
 *
 * @param range the addresses
 * @param name the name; beside addresses that of the player who was banned with them, or null
 * @param account the account, as join tokens name it
 * @param until when it ends, or null for never
 * @param reason for players and operators, may be empty
 */
record AccessEntry(AddressRange range, String name, String account, Instant until, String reason) {
  private static final String ADDRESS = "address";
  private static final String NAME = "name";
  private static final String ACCOUNT = "account";
  private static final String UNTIL = "until";
  private static final String OF = "of";
  private static final List<String> KINDS = List.of(ADDRESS, NAME, ACCOUNT);

  /** Words that a reason may not begin with, unless in quotes. */
  private static final List<String> KEYWORDS = List.of(UNTIL, OF);

  /** Checks that all of it fits into a line. */
  AccessEntry {
    if (Stream.of(name, account, reason)
        .anyMatch(text -> text != null && text.matches("(?s).*[\\n\\r].*"))) {
      throw new IllegalArgumentException("names, accounts and reasons have no line ends");
    }
  }

  /**
   * Returns the entry of a line.
   *
   * @throws IllegalArgumentException if it is none; the message says what is wrong
   */
  static AccessEntry parse(String line) {
    List<Quoting.Word> words = Quoting.words(line);
    if (words.size() < 2 || KINDS.stream().noneMatch(words.get(0)::is)) {
      throw new IllegalArgumentException(
          "lines look like: address 203.0.113.7, or: name \"Bob B\" until 2026-12-01T00:00:00Z"
              + " REASON");
    }
    Instant until = null;
    int next = 2;
    String of = null;
    if (words.get(0).is(ADDRESS) && words.size() > 3 && words.get(2).is(OF)) {
      of = words.get(3).text();
      next = 4;
    }
    if (words.size() > next && words.get(next).is(UNTIL)) {
      String time = words.size() > next + 1 ? words.get(next + 1).text() : "";
      try {
        until = Instant.parse(time);
      } catch (DateTimeException e) {
        throw new IllegalArgumentException(
            UNTIL + "=" + time + " is no time such as 2026-12-01T00:00:00Z", e);
      }
      next += 2;
    }
    String reason =
        words.stream().skip(next).map(Quoting.Word::text).collect(Collectors.joining(" "));
    String value = words.get(1).text();
    if (words.get(0).is(NAME)) {
      return new AccessEntry(null, value, null, until, reason);
    }
    if (words.get(0).is(ACCOUNT)) {
      return new AccessEntry(null, null, value, until, reason);
    }
    Optional<AddressRange> range = AddressRange.parse(value);
    return new AccessEntry(
        range.orElseThrow(() -> new IllegalArgumentException(AddressRange.problem(value))),
        of,
        null,
        until,
        reason);
  }

  /** Returns whether this is about a client at a time. */
  boolean covers(String player, String playersAccount, byte[] address, Instant now) {
    if (until != null && !now.isBefore(until)) {
      return false;
    }
    if (range != null) {
      return address != null && range.contains(address);
    }
    return account != null
        ? account.equals(playersAccount)
        : player != null && PlayerName.looksLike(name, player);
  }

  /** Returns whether this is about the same name, account or addresses as another. */
  boolean isAboutSame(AccessEntry other) {
    if (range != null || account != null) {
      return Objects.equals(range, other.range) && Objects.equals(account, other.account);
    }
    return other.range == null && isOf(other.name);
  }

  /** Returns what this is about; the same for each {@linkplain #isAboutSame same} entry. */
  String subject() {
    if (range != null) {
      return ADDRESS + " " + range;
    }
    return account != null ? ACCOUNT + " " + account : NAME + " " + PlayerName.folded(name);
  }

  /** Returns whether this is about a name, or about an address that was banned together with it. */
  boolean isOf(String player) {
    return name != null
        && player != null
        && PlayerName.folded(name).equals(PlayerName.folded(player));
  }

  /** Returns the line in the file. */
  String line() {
    return what()
        + (until == null ? "" : " " + UNTIL + " " + until)
        + (reason.isEmpty() ? "" : " " + (readsAsWords(reason) ? reason : Quoting.quoted(reason)));
  }

  /** Returns whether a reason is read back as it is without quotes around it. */
  private static boolean readsAsWords(String reason) {
    List<String> words = List.of(reason.split(" ", -1));
    return !KEYWORDS.contains(words.get(0))
        && words.stream().allMatch(word -> word.equals(Quoting.shown(word)));
  }

  /** Returns what it is about, as in the file. */
  String what() {
    if (range != null) {
      return ADDRESS + " " + range + (name == null ? "" : " " + OF + " " + Quoting.quoted(name));
    }
    return (account != null ? ACCOUNT : NAME) + " " + Quoting.quoted(value());
  }

  /** Returns the addresses, the name or the account. */
  String value() {
    if (range != null) {
      return range.toString();
    }
    return account != null ? account : name;
  }
}
