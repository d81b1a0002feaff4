package carom.server.fleet;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** The words that an operator says to a fleet. */
enum FleetVerb {
  /** Shows the servers. */
  STATUS(""),
  /** Shows the rooms, their owners and followers. */
  ROOMS(""),
  /** Moves a running room. */
  MOVE(" ROOM [SERVER]"),
  /** Moves all rooms of a server away; it takes no more. */
  DRAIN(" SERVER"),
  /** Lets a server that was drained take rooms and players again. */
  UNDRAIN(" SERVER");

  private final String operands;

  FleetVerb(String operands) {
    this.operands = operands;
  }

  /** Returns the verb as it is typed. */
  String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns how it is used. */
  String usage() {
    return word() + operands;
  }

  /** Returns the most words behind it. */
  int most() {
    return operands.isEmpty() ? 0 : operands.strip().split(" ").length;
  }

  /** Returns whether a word must stand behind it: the room or the server that it is about. */
  boolean needsName() {
    return !operands.isEmpty();
  }

  /**
   * Returns the verb of a line, {@link #STATUS} for none.
   *
   * @throws IllegalArgumentException if it begins with none of them, or has too many words
   */
  static FleetVerb of(List<String> words) {
    if (words.isEmpty()) {
      return STATUS;
    }
    for (FleetVerb verb : values()) {
      if (verb.word().equals(words.get(0))) {
        if (words.size() - 1 > verb.most()) {
          throw new IllegalArgumentException("use it like this: fleet " + verb.usage());
        }
        return verb;
      }
    }
    throw new IllegalArgumentException("\"" + words.get(0) + "\" is none of " + usages(", "));
  }

  /** Returns how all are used. */
  static String usages(String between) {
    return Arrays.stream(values()).map(FleetVerb::usage).collect(Collectors.joining(between));
  }
}
