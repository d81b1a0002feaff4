package carom.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.game.Games;
import carom.options.Setting;
import carom.server.config.ServerConfig;
import carom.sim.Game;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.ServiceLoader;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/**
 * The table of settings in {@code docs/server/OPERATIONS.md} is that of the rows. {@code
 * -Dcarom.renew=true} writes it anew.
 */
final class SettingsTableTest {
  private static final String HEAD = "| setting | value | default | at once | what it does |";

  @Test
  void theTableIsThatOfTheRows() throws Exception {
    Path page = page();
    List<String> lines = new ArrayList<>(Files.readAllLines(page));
    int first = lines.indexOf(HEAD);
    int end = first;
    while (end < lines.size() && lines.get(end).startsWith("|")) {
      end++;
    }
    List<String> expected = table();
    if (Boolean.getBoolean("carom.renew")) {
      lines.subList(first, end).clear();
      lines.addAll(first, expected);
      Files.writeString(page, String.join("\n", lines) + "\n");
    } else {
      assertEquals(expected, lines.subList(first, end), "renew it with -Dcarom.renew=true");
    }
  }

  private static List<String> table() {
    String known = String.join(", ", Games.names()); // other tests may have added some
    String shipped =
        ServiceLoader.load(Game.class).stream()
            .map(game -> game.get().name())
            .sorted()
            .collect(Collectors.joining(", "));
    List<String> table = new ArrayList<>(List.of(HEAD, "| --- | --- | --- | --- | --- |"));
    for (Setting<?> row : ServerConfig.ROWS.all()) {
      String range = row.range().isEmpty() ? row.label() : row.range() + " " + row.unit();
      range =
          row.initial() instanceof String && !row.range().isEmpty() ? range + "characters" : range;
      table.add(
          String.format(
              "| `%s` | %s | %s | %s | %s |",
              row.name(),
              range.strip().replace("|", "\\|"),
              row.shown(row.initialText()),
              row.isLive() ? "yes" : "",
              row.doc().replace(known, shipped).replace("|", "\\|")));
    }
    return table;
  }

  private static Path page() {
    Path folder = Path.of("").toAbsolutePath();
    while (!Files.exists(folder.resolve("docs/server/OPERATIONS.md"))) {
      folder = folder.getParent();
    }
    return folder.resolve("docs/server/OPERATIONS.md");
  }
}
