package carom.client.settings;

import carom.net.protocol.PlayerName;
import carom.net.protocol.RoomName;
import carom.options.Rows;
import carom.options.Setting;
import carom.options.Settings;
import carom.sim.message.PlayerColour;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The settings of a player: a row for each, which is also its line in the file, and a value for
 * each row. Immutable; start from {@link #defaults}.
 */
public final class PlayerSettings extends Settings<PlayerSettings> {
  /** Most actions of games of which the keys are kept. */
  private static final int MAX_GAME_KEYS = 500;

  /** Most servers in the list of recent ones. */
  public static final int MAX_RECENT = 8;

  /** Most servers in the list of favourites. */
  public static final int MAX_FAVOURITES = 20;

  /** All settings, in the order of the file. */
  static final Rows ROWS = Rows.inner();

  private static final String SIZE = "(\\d+) *x *(\\d+)";

  public static final Setting<String> NAME =
      ROWS.text("name", "NAME", "player")
          .text("name in games")
          .checked(PlayerSettings::nameProblem);

  public static final Setting<String> PARTY =
      ROWS.text("party", "NAME", "")
          .text("of friends who play in one room; empty for none")
          .checked(PlayerSettings::partyProblem);

  public static final Setting<PlayerColour> COLOUR =
      labelled("colour", PlayerColour.values(), PlayerColour::label, "of the own body: {choices}");

  public static final Setting<Integer> VOLUME =
      ROWS.whole("volume", "N", 0, 100, 25).text("{range} %");

  public static final Setting<WindowSize> WINDOW =
      ROWS.of("window", "SIZE", PlayerSettings::size, "1280 x 720")
          .text("width x height, pixels")
          .checked(PlayerSettings::sizeProblem);

  public static final Setting<Boolean> FULLSCREEN =
      ROWS.toggle("fullscreen", false).text("true or false");

  public static final Setting<Boolean> VSYNC =
      ROWS.toggle("vsync", true)
          .text("true: pictures wait for the screen; false: they come sooner, and may tear");

  public static final Setting<Integer> TEXT_SIZE =
      ROWS.whole("text-size", "N", 75, 200, 100).text("{range} %");

  public static final Setting<Palette> PALETTE =
      labelled("colours", Palette.values(), Palette::label, "{choices}");

  public static final Setting<Integer> INTERPOLATION =
      ROWS.whole("interpolation", "N", 0, 300, 0)
          .text("least delay of other players' bodies, {range} ms; 0 = as little as possible");

  private static final Map<KeyAction, Setting<List<String>>> KEYS = new EnumMap<>(KeyAction.class);

  static {
    for (KeyAction action : KeyAction.values()) {
      String usual = String.join(", ", action.defaults());
      KEYS.put(
          action,
          ROWS.of(action.settingName(), "KEYS", text -> list(text, Integer.MAX_VALUE), usual)
              .text(action.label()));
    }
  }

  private static final Setting<Map<String, List<String>>> GAME_KEYS =
      ROWS.of("game-keys", "KEYS", PlayerSettings::gameKeys, "")
          .text("of games' own actions, such as: tag.sprint: Space, F | tag.jump: W")
          .written(PlayerSettings::written);

  public static final Setting<List<String>> RECENT =
      ROWS.of("recent", "SERVERS", text -> list(text, MAX_RECENT), "")
          .text("servers, the last one first");

  public static final Setting<List<String>> FAVOURITES =
      ROWS.of("favourites", "SERVERS", text -> list(text, MAX_FAVOURITES), "").text("servers");

  /**
   * Size of the window.
   *
   * @param width 640..16,384 px
   * @param height 360..16,384 px
   */
  public record WindowSize(int width, int height) {
    @Override
    public String toString() {
      return width + " x " + height;
    }
  }

  private PlayerSettings() {}

  /** Returns the settings of a player who has set nothing. */
  public static PlayerSettings defaults() {
    return new PlayerSettings();
  }

  private static <E extends Enum<E>> Setting<E> labelled(
      String name, E[] values, Function<E, String> label, String text) {
    String words = Stream.of(values).map(label).collect(Collectors.joining(", "));
    return ROWS.of(
            name,
            "WORD",
            word ->
                Stream.of(values)
                    .filter(value -> label.apply(value).equals(word))
                    .findFirst()
                    .orElseThrow(() -> new IllegalArgumentException("not one of: " + words)),
            label.apply(values[0]))
        .text(text)
        .written(label)
        .choices(() -> words);
  }

  private static String nameProblem(String name) {
    String problem = PlayerName.problem(name);
    return problem == null ? null : ": " + problem;
  }

  private static String partyProblem(String party) {
    String problem = party.isEmpty() ? null : RoomName.partyProblem(party);
    return problem == null ? null : ": " + problem;
  }

  private static WindowSize size(String text) {
    if (!text.matches(SIZE) || text.length() > 20) {
      throw new IllegalArgumentException("not like 1280 x 720");
    }
    return new WindowSize(
        Integer.parseInt(text.replaceFirst(SIZE, "$1")),
        Integer.parseInt(text.replaceFirst(SIZE, "$2")));
  }

  private static String sizeProblem(WindowSize size) {
    return size.width < 640 || size.width > 16_384 || size.height < 360 || size.height > 16_384
        ? "is outside 640 x 360..16384 x 16384"
        : null;
  }

  private static List<String> list(String text, int most) {
    return Stream.of(text.split(","))
        .map(String::strip)
        .filter(word -> !word.isEmpty())
        .distinct()
        .limit(most)
        .toList();
  }

  /**
   * Returns a copy with a line of the file.
   *
   * @throws IllegalArgumentException if the value can't be used
   */
  <T> PlayerSettings withLine(Setting<T> row, String text) {
    for (Map.Entry<KeyAction, Setting<List<String>>> key : KEYS.entrySet()) {
      if (key.getValue() == row) {
        return withKeys(key.getKey(), key.getValue().parse(List.of(text)));
      }
    }
    return parse(row, List.of(text));
  }

  /** Returns a copy with a window of this size. */
  public PlayerSettings withWindow(int width, int height) {
    return with(WINDOW, new WindowSize(width, height));
  }

  /** Returns the names of the keys of each action. */
  public Map<KeyAction, List<String>> keys() {
    Map<KeyAction, List<String>> keys = new EnumMap<>(KeyAction.class);
    KEYS.forEach((action, row) -> keys.put(action, get(row)));
    return keys;
  }

  /** Returns a copy with these keys for an action, which lose what they did before. */
  public PlayerSettings withKeys(KeyAction action, List<String> names) {
    PlayerSettings changed = this;
    for (Setting<List<String>> row : KEYS.values()) {
      List<String> left = new ArrayList<>(get(row));
      left.removeAll(names);
      changed = changed.with(row, List.copyOf(left));
    }
    return changed.with(KEYS.get(action), List.copyOf(names));
  }

  private static Map<String, List<String>> gameKeys(String text) {
    Map<String, List<String>> keys = new TreeMap<>();
    for (String entry : text.split("\\|")) {
      int at = (entry + " ").indexOf(": ");
      if (at > 0 && keys.size() < MAX_GAME_KEYS) {
        keys.put(entry.substring(0, at).strip(), list(entry.substring(at + 1), MAX_GAME_KEYS));
      }
    }
    return keys;
  }

  private static String written(Map<String, List<String>> keys) {
    return keys.entrySet().stream()
        .map(entry -> entry.getKey() + ": " + String.join(", ", entry.getValue()))
        .collect(Collectors.joining(" | "));
  }

  /** Returns the keys that the player has chosen for an action of a game, or null for none. */
  public List<String> gameKeys(String game, String action) {
    return get(GAME_KEYS).get(game + "." + action);
  }

  /** Returns a copy with other keys for an action of a game; null for those of the game. */
  public PlayerSettings withGameKeys(String game, String action, List<String> names) {
    Map<String, List<String>> changed = new TreeMap<>(get(GAME_KEYS));
    if (names == null) {
      changed.remove(game + "." + action);
    } else {
      changed.put(game + "." + action, List.copyOf(names));
    }
    return with(GAME_KEYS, changed);
  }

  /** Returns a copy with the default keys, also of games. */
  public PlayerSettings withDefaultKeys() {
    PlayerSettings changed = with(GAME_KEYS, null);
    for (Setting<List<String>> row : KEYS.values()) {
      changed = changed.with(row, null);
    }
    return changed;
  }

  /** Returns a copy in which a server was played on last. */
  public PlayerSettings withRecent(String server) {
    return with(RECENT, first(server, get(RECENT), MAX_RECENT));
  }

  /** Returns a copy in which a server is a favourite, or isn't one any more if it was. */
  public PlayerSettings withFavouriteToggled(String server) {
    List<String> favourites = get(FAVOURITES);
    return with(
        FAVOURITES,
        favourites.contains(server)
            ? favourites.stream().filter(other -> !other.equals(server)).toList()
            : first(server, favourites, MAX_FAVOURITES));
  }

  private static List<String> first(String server, List<String> servers, int most) {
    return Stream.concat(Stream.of(server), servers.stream()).distinct().limit(most).toList();
  }
}
