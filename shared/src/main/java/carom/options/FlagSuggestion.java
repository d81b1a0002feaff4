package carom.options;

import carom.text.Suggestion;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Finds the flags that a person probably meant: by words that other programs use for the same, by
 * spelling, and by a part of the name.
 */
final class FlagSuggestion {
  private static final int MOST = 3;

  /** Flags by what else they are called. Only those that a program has are suggested. */
  private static final Map<String, List<String>> OTHER_WORDS =
      Map.ofEntries(
          Map.entry("bots", List.of("--count")),
          Map.entry("n", List.of("--count")),
          Map.entry("players", List.of("--max-players", "--count")),
          Map.entry("clients", List.of("--max-players", "--count")),
          Map.entry("slots", List.of("--max-players")),
          Map.entry("server", List.of("--host")),
          Map.entry("connect", List.of("--host")),
          Map.entry("address", List.of("--host", "--bind")),
          Map.entry("port", List.of("--tcp-port", "--host")),
          Map.entry("ip", List.of("--host", "--bind")),
          Map.entry("listen", List.of("--bind")),
          Map.entry("map", List.of("--level")),
          Map.entry("hz", List.of("--tick-rate")),
          Map.entry("fps", List.of("--tick-rate")),
          Map.entry("time", List.of("--seconds")),
          Map.entry("duration", List.of("--seconds")),
          Map.entry("ping", List.of("--latency")),
          Map.entry("lag", List.of("--latency")),
          Map.entry("user", List.of("--name")),
          Map.entry("nick", List.of("--name")),
          Map.entry("verbose", List.of("--log-level")),
          Map.entry("debug", List.of("--log-level")),
          Map.entry("folder", List.of("--data")),
          Map.entry("save", List.of("--checkpoint")));

  private FlagSuggestion() {}

  /**
   * Returns at most three known flags, the likeliest first.
   *
   * @param flag as the user wrote it, perhaps with {@code =VALUE} behind it
   * @param known long names of the program's flags, with their dashes
   */
  static List<String> of(String flag, Collection<String> known) {
    int end = flag.indexOf('=');
    String word = bare(end < 0 ? flag : flag.substring(0, end));
    Set<String> found = new LinkedHashSet<>();
    OTHER_WORDS.getOrDefault(word, List.of()).stream().filter(known::contains).forEach(found::add);
    String nearest = Suggestion.nearest("--" + word, known);
    if (nearest != null) {
      found.add(nearest);
    }
    List<String> parts = Arrays.asList(word.split("-", -1));
    for (String candidate : known) {
      if (!Collections.disjoint(parts, Arrays.asList(bare(candidate).split("-", -1)))) {
        found.add(candidate);
      }
    }
    return new ArrayList<>(found).subList(0, Math.min(MOST, found.size()));
  }

  private static String bare(String flag) {
    return flag.replaceFirst("^-+", "");
  }
}
