package carom.server.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Slice;
import carom.options.Flags;
import carom.options.Setting;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/**
 * Goal: whatever the door, a setting is the same. Method: random texts for each row, by flag,
 * variable and file; the values or the errors must be equal.
 */
final class SettingDoorsTest {
  private static final long SEED = Long.getLong("carom.seed", 39);

  private static final List<String> TEXTS =
      List.of(
          "0",
          "1",
          "7",
          "30",
          "64",
          "512",
          "8090",
          "65535",
          "65536",
          "-1",
          "0.5",
          "1e3",
          "NaN",
          "99999999999",
          "30 s",
          "0.5 min",
          "250ms",
          "2 Mbit",
          "60Hz",
          "60 hz",
          "50 %",
          "1 parsec",
          "true",
          "FALSE",
          "yes",
          "off",
          "pause",
          "Run",
          "on",
          "debug",
          "loud",
          "wifi",
          "arena",
          "cup=arena:4",
          "127.0.0.1",
          "10.0.0.0/8",
          "two words",
          "a\"b",
          "#x",
          "// y",
          "$z",
          "ä");

  private final Random random = new Random(SEED);

  @TempDir private Path folder;

  @Test
  void eachRowIsTheSameByFlagVariableAndFile() throws Exception {
    int good = 0;
    int bad = 0;
    double texts = Slice.of(8, 25);
    for (Setting<?> row : ServerConfig.ROWS.all()) {
      for (int i = 0; i < texts; i++) {
        String text = text();
        String told = "seed=" + SEED + " " + row + "=" + text;
        Object byFlag = outcome(row, new String[] {row + "=" + text}, Map.of());
        assertEquals(byFlag, outcome(row, new String[0], Map.of(row.variable(), text)), told);
        Path file = folder.resolve("settings.conf");
        String quoted = "\"" + text.replace("\"", "\\\"") + "\""; // no text has a backslash
        Files.writeString(
            file, row.name() + " = " + (row.isList() ? "[" + quoted + "]" : quoted) + "\n");
        Object byFile = outcome(row, new String[] {"--config", file.toString()}, Map.of());
        assertEquals(byFlag, byFile, told);
        if (byFlag instanceof String error && error.startsWith("refused: ")) {
          assertTrue(error.startsWith("refused: " + row), told + " " + error);
          bad++;
        } else {
          good++;
        }
      }
    }
    assertTrue(
        good > 16 * texts && bad > 16 * texts, "seed=" + SEED + " good=" + good + " bad=" + bad);
  }

  @Test
  void aValueInAnotherUnitIsNoChange() {
    int compared = 0;
    for (Setting<?> row : ServerConfig.ROWS.all()) {
      for (int i = 0; i < 200 && !row.unit().isEmpty(); i++) {
        int number = random.nextInt(2_000);
        if (isRefused(row, String.valueOf(number)) || isRefused(row, String.valueOf(number + 1))) {
          continue;
        }
        EffectiveSetting plain = setting(row, String.valueOf(number));
        String told = "seed=" + SEED + " " + row + "=" + number;
        assertTrue(plain.isSameAs(setting(row, number + " " + row.unit())), told);
        assertTrue(plain.isSameAs(setting(row, number + ".0" + row.unit())), told);
        assertFalse(plain.isSameAs(setting(row, number + 1 + " " + row.unit())), told);
        compared++;
      }
    }
    assertTrue(compared > 400, "seed=" + SEED + " compared=" + compared);
  }

  private static EffectiveSetting setting(Setting<?> row, String text) {
    return new EffectiveSetting(row, List.of(text), "carom.conf: 1");
  }

  private static boolean isRefused(Setting<?> row, String text) {
    try {
      row.parse(List.of(text));
      return false;
    } catch (IllegalArgumentException e) {
      return true;
    }
  }

  private String text() {
    return random.nextInt(4) == 0
        ? String.valueOf(random.nextInt(2_000))
        : TEXTS.get(random.nextInt(TEXTS.size()));
  }

  /** Returns the value of a setting, or the error. */
  private static Object outcome(Setting<?> row, String[] args, Map<String, String> environment)
      throws BadSettingException {
    CommandLine program = new CommandLine(CommandLine.Model.CommandSpec.create());
    Flags.add(program.getCommandSpec(), ServerConfig.ROWS);
    Flags.add(program.getCommandSpec(), ServerConfig.ONLY_FLAGS);
    try {
      CommandLine.ParseResult parsed = program.parseArgs(args);
      Map<String, List<String>> given = Flags.given(parsed, ServerConfig.ROWS);
      given.putAll(Flags.given(parsed, ServerConfig.ONLY_FLAGS));
      Object value = new SettingsLayers(given, environment, Map.of()).settings().config().get(row);
      return value instanceof List<?> list ? new ArrayList<>(list) : value;
    } catch (IllegalArgumentException e) {
      return "refused: " + e.getMessage();
    } catch (CommandLine.ParameterException e) {
      return "refused: " + e.getCause().getMessage(); // as BadFlag prints it
    }
  }
}
