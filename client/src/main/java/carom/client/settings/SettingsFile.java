package carom.client.settings;

import carom.options.Setting;
import carom.text.FileErrors;
import carom.text.Suggestion;
import carom.text.TextFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/**
 * Keeps {@link PlayerSettings} in one text file of lines {@code name = value}. Nothing of a file
 * that can't be read as a whole is lost: the file is kept aside under another name, and the
 * problems are told. Not thread-safe.
 */
public final class SettingsFile {
  private static final String FILE = "player.conf";
  private static final String ASIDE = ".unreadable";
  private static final int MAX_BYTES = 100_000;

  private final Path file;
  private PlayerSettings settings = PlayerSettings.defaults();
  private String problem = "";

  /** Creates one over a file that needn't exist; call {@link #load} next. */
  public SettingsFile(Path file) {
    this.file = file;
  }

  /** Returns the file in the folder in which this system's users keep settings. */
  public static Path usual() {
    return usual(System.getProperty("os.name"), System.getProperty("user.home"), System::getenv);
  }

  static Path usual(String system, String home, Function<String, String> environment) {
    if (system.startsWith("Windows")) {
      String roaming = environment.apply("APPDATA");
      return Path.of(roaming == null ? home : roaming, "Carom", FILE);
    }
    if (system.startsWith("Mac")) {
      return Path.of(home, "Library", "Application Support", "Carom", FILE);
    }
    String config = environment.apply("XDG_CONFIG_HOME");
    if (config == null || !config.startsWith("/")) { // others are to be ignored
      String ofShell = environment.apply("HOME"); // Java's own comes from the list of accounts
      config = (ofShell == null || ofShell.isEmpty() ? home : ofShell) + "/.config";
    }
    return Path.of(config, "carom", FILE);
  }

  /**
   * Reads the file. What it doesn't have is as by default. If a line or the whole file can't be
   * read, the file is copied aside and {@link #problem} says so.
   */
  public PlayerSettings load() {
    List<String> problems = new ArrayList<>();
    settings = PlayerSettings.defaults();
    try {
      int number = 0;
      for (String line : TextFile.read(file, MAX_BYTES).split("\\R")) {
        number++;
        try {
          settings = read(settings, line.strip());
        } catch (IllegalArgumentException e) {
          problems.add("line " + number + ": " + e.getMessage());
        }
      }
    } catch (NoSuchFileException e) {
      return settings; // nothing was set yet
    } catch (IOException e) {
      problems.add(FileErrors.reason(e));
    }
    if (!problems.isEmpty()) {
      problem = file + ": " + String.join("; ", problems) + ". " + keepAside();
    }
    return settings;
  }

  private static PlayerSettings read(PlayerSettings settings, String text) {
    if (text.isEmpty() || text.startsWith("#")) {
      return settings;
    }
    int at = text.indexOf('=');
    if (at < 0) {
      throw new IllegalArgumentException("\"" + text + "\" is not like name = value");
    }
    String name = text.substring(0, at).strip();
    for (Setting<?> row : PlayerSettings.ROWS.all()) {
      if (row.name().equals(name)) {
        return settings.withLine(row, text.substring(at + 1).strip());
      }
    }
    List<String> names = PlayerSettings.ROWS.all().stream().<String>map(Setting::name).toList();
    throw new IllegalArgumentException(
        "unknown setting " + name + Suggestion.didYouMean(name, names));
  }

  private String keepAside() {
    Path aside = file.resolveSibling(file.getFileName() + ASIDE);
    try {
      for (int i = 2; Files.exists(aside) && Files.mismatch(file, aside) >= 0; i++) {
        aside = file.resolveSibling(file.getFileName() + ASIDE + "-" + i);
      }
      Files.copy(file, aside, StandardCopyOption.REPLACE_EXISTING);
      return "The file is kept as " + aside.getFileName() + ".";
    } catch (IOException e) {
      return "It can't be kept aside either (" + FileErrors.reason(e) + "), so nothing is saved.";
    }
  }

  /** Returns what couldn't be read or written, in words for the player; empty if nothing. */
  public String problem() {
    return problem;
  }

  /** Returns the present settings. */
  public PlayerSettings settings() {
    return settings;
  }

  /** Changes the settings and writes the file. If it can't be written, {@link #problem} says so. */
  public void save(PlayerSettings changed) {
    if (changed.equals(settings) && Files.exists(file)) {
      return;
    }
    settings = changed;
    if (problem.endsWith("nothing is saved.")) {
      return;
    }
    try {
      Files.createDirectories(file.toAbsolutePath().getParent());
      Path written = file.resolveSibling(file.getFileName() + ".new");
      Files.writeString(written, text(changed));
      Files.move(written, file, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      problem = "The settings can't be saved: " + FileErrors.reason(e);
    }
  }

  private static String text(PlayerSettings settings) {
    StringBuilder text = new StringBuilder("# Carom's settings; the client writes them here.\n");
    for (Setting<?> row : PlayerSettings.ROWS.all()) {
      text.append("\n# ").append(row.doc()).append('\n');
      text.append(row.name()).append(" = ").append(settings.text(row)).append('\n');
    }
    return text.toString();
  }
}
