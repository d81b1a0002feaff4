package carom.client.settings;

import carom.sim.message.PlayerColour;
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
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Keeps {@link PlayerSettings} in one text file of lines {@code name = value}. Nothing of a file
 * that can't be read as a whole is lost: the file is kept aside under another name, and the
 * problems are told. Not thread-safe.
 */
public final class SettingsFile {
  private static final String FILE = "player.conf";
  private static final String ASIDE = ".unreadable";
  private static final int MAX_BYTES = 100_000;

  /**
   * A setting of the file.
   *
   * @param name its name
   * @param about what it is, in a line
   * @param write returns its value as text
   * @param read returns settings with a value from text; IllegalArgumentException if it can't
   */
  private record Line(
      String name,
      String about,
      Function<PlayerSettings, String> write,
      BiFunction<PlayerSettings, String, PlayerSettings> read) {}

  private static final List<Line> LINES = lines();

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

  /** Returns the lines of the file. */
  private static List<Line> lines() {
    List<Line> lines = new ArrayList<>();
    lines.add(new Line("name", "name in games", s -> s.name(), (s, v) -> s.withName(v)));
    lines.add(
        new Line(
            "colour",
            "of the own body: " + labels(PlayerColour.values(), PlayerColour::label),
            s -> s.colour().label(),
            (s, v) ->
                s.withColour(labelled("colour", PlayerColour.values(), PlayerColour::label, v))));
    lines.add(
        new Line(
            "volume",
            "0..100 %",
            s -> "" + s.volume(),
            (s, v) -> s.withVolume(number("volume", v))));
    lines.add(
        new Line(
            "window",
            "width x height, pixels",
            s -> s.windowWidth() + " x " + s.windowHeight(),
            SettingsFile::window));
    lines.add(
        new Line(
            "fullscreen",
            "true or false",
            s -> "" + s.fullscreen(),
            (s, v) -> s.withFullscreen(flag("fullscreen", v))));
    lines.add(
        new Line(
            "vsync",
            "true: pictures wait for the screen; false: they come sooner, and may tear",
            s -> "" + s.vsync(),
            (s, v) -> s.withVsync(flag("vsync", v))));
    lines.add(
        new Line(
            "text-size",
            "75..200 %",
            s -> "" + s.textSize(),
            (s, v) -> s.withTextSize(number("text-size", v))));
    lines.add(
        new Line(
            "colours",
            labels(Palette.values(), Palette::label),
            s -> s.palette().label(),
            (s, v) -> s.withPalette(labelled("colours", Palette.values(), Palette::label, v))));
    lines.add(
        new Line(
            "interpolation",
            "least delay of other players' bodies, 0..300 ms; 0 = as little as possible",
            s -> "" + s.interpolationMs(),
            (s, v) -> s.withInterpolationMs(number("interpolation", v))));
    for (KeyAction action : KeyAction.values()) {
      lines.add(
          new Line(
              action.settingName(),
              action.label(),
              s -> String.join(", ", s.keys().get(action)),
              (s, v) -> s.withKeys(action, list(v))));
    }
    lines.add(
        new Line(
            "recent",
            "servers, the last one first",
            s -> String.join(", ", s.recent()),
            (s, v) -> each(s, list(v), PlayerSettings::withRecent)));
    lines.add(
        new Line(
            "favourites",
            "servers",
            s -> String.join(", ", s.favourites()),
            (s, v) -> each(s, list(v), PlayerSettings::withFavouriteToggled)));
    return lines;
  }

  /** Adds servers from the last to the first, as each addition goes to the front. */
  private static PlayerSettings each(
      PlayerSettings settings,
      List<String> servers,
      BiFunction<PlayerSettings, String, PlayerSettings> add) {
    PlayerSettings changed = settings;
    for (int i = servers.size() - 1; i >= 0; i--) {
      if (servers.indexOf(servers.get(i)) == i) {
        changed = add.apply(changed, servers.get(i));
      }
    }
    return changed;
  }

  private static int number(String name, String text) {
    try {
      return Integer.parseInt(text);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(name + "=" + text + " is not a whole number", e);
    }
  }

  private static boolean flag(String name, String text) {
    if (!text.equals("true") && !text.equals("false")) {
      throw new IllegalArgumentException(name + "=" + text + " is neither true nor false");
    }
    return text.equals("true");
  }

  private static PlayerSettings window(PlayerSettings settings, String text) {
    String[] sides = text.split("x", 3);
    if (!text.matches("\\d+ *x *\\d+")) {
      throw new IllegalArgumentException("window=" + text + " is not like 1280 x 720");
    }
    return settings.withWindow(
        number("window", sides[0].strip()), number("window", sides[1].strip()));
  }

  private static <T> String labels(T[] values, Function<T, String> label) {
    return Stream.of(values).map(label).collect(Collectors.joining(", "));
  }

  private static <T> T labelled(String name, T[] values, Function<T, String> label, String text) {
    for (T value : values) {
      if (label.apply(value).equals(text)) {
        return value;
      }
    }
    throw new IllegalArgumentException(
        name + "=" + text + " is not one of: " + labels(values, label));
  }

  private static List<String> list(String text) {
    return Stream.of(text.split(",")).map(String::strip).filter(s -> !s.isEmpty()).toList();
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
    for (Line line : LINES) {
      if (line.name.equals(name)) {
        return line.read.apply(settings, text.substring(at + 1).strip());
      }
    }
    List<String> names = LINES.stream().map(Line::name).toList();
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
    for (Line line : LINES) {
      text.append("\n# ").append(line.about).append('\n');
      text.append(line.name).append(" = ").append(line.write.apply(settings)).append('\n');
    }
    return text.toString();
  }
}
