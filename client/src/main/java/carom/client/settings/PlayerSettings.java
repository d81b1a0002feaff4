package carom.client.settings;

import carom.net.protocol.PlayerName;
import carom.sim.message.PlayerColour;
import carom.values.Records;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * The settings of a player. Immutable; start from {@link #defaults}.
 *
 * @param name the player's name, see {@link PlayerName}
 * @param colour colour of the player's body, in games that let players choose
 * @param volume loudness of the sounds, 0..100 %
 * @param windowWidth width of the window, 640..16,384 px
 * @param windowHeight height of the window, 360..16,384 px
 * @param fullscreen whether the window fills the screen
 * @param vsync whether pictures wait for the screen
 * @param textSize size of texts and panels, 75..200 %
 * @param palette colours in which games are drawn
 * @param interpolationMs least time by which other players' bodies are drawn late, 0..300 ms; 0 =
 *     as little as the connection allows
 * @param keys names of the keys of each action
 * @param recent addresses of the servers that were played on, the last one first
 * @param favourites addresses of the servers that the player marked
 */
public record PlayerSettings(
    String name,
    PlayerColour colour,
    int volume,
    int windowWidth,
    int windowHeight,
    boolean fullscreen,
    boolean vsync,
    int textSize,
    Palette palette,
    int interpolationMs,
    Map<KeyAction, List<String>> keys,
    List<String> recent,
    List<String> favourites) {
  /** Most servers in the list of recent ones. */
  public static final int MAX_RECENT = 8;

  /** Most servers in the list of favourites. */
  public static final int MAX_FAVOURITES = 20;

  /**
   * Checks the ranges.
   *
   * @throws IllegalArgumentException names value and range
   */
  public PlayerSettings {
    String problem = PlayerName.problem(name);
    if (problem != null) {
      throw new IllegalArgumentException(problem);
    }
    require("volume", volume, 0, 100);
    require("window width", windowWidth, 640, 16_384);
    require("window height", windowHeight, 360, 16_384);
    require("text-size", textSize, 75, 200);
    require("interpolation", interpolationMs, 0, 300);
    require("recent", recent.size(), 0, MAX_RECENT);
    require("favourites", favourites.size(), 0, MAX_FAVOURITES);
    Map<KeyAction, List<String>> copy = new EnumMap<>(KeyAction.class);
    for (KeyAction action : KeyAction.values()) {
      copy.put(action, List.copyOf(keys.getOrDefault(action, action.defaults())));
    }
    keys = Collections.unmodifiableMap(copy);
    recent = List.copyOf(recent);
    favourites = List.copyOf(favourites);
  }

  private static void require(String name, int value, int min, int max) {
    if (value < min || value > max) {
      throw new IllegalArgumentException(name + "=" + value + " is outside " + min + ".." + max);
    }
  }

  /** Returns the settings of a player who has set nothing. */
  public static PlayerSettings defaults() {
    return new PlayerSettings(
        /* name= */ "player",
        /* colour= */ PlayerColour.OF_THE_GAME,
        /* volume= */ 25,
        /* windowWidth= */ 1_280,
        /* windowHeight= */ 720,
        /* fullscreen= */ false,
        /* vsync= */ true,
        /* textSize= */ 100,
        /* palette= */ Palette.STANDARD,
        /* interpolationMs= */ 0,
        /* keys= */ Map.of(),
        /* recent= */ List.of(),
        /* favourites= */ List.of());
  }

  /** Returns a copy for a player of this name. */
  public PlayerSettings withName(String name) {
    return Records.with(this, "name", name);
  }

  /** Returns a copy with a body of this colour. */
  public PlayerSettings withColour(PlayerColour colour) {
    return Records.with(this, "colour", colour);
  }

  /** Returns a copy with this loudness. */
  public PlayerSettings withVolume(int volume) {
    return Records.with(this, "volume", volume);
  }

  /** Returns a copy with a window of this size. */
  public PlayerSettings withWindow(int width, int height) {
    return Records.with(this, "windowWidth", width, "windowHeight", height);
  }

  /** Returns a copy whose window fills the screen, or not. */
  public PlayerSettings withFullscreen(boolean fullscreen) {
    return Records.with(this, "fullscreen", fullscreen);
  }

  /** Returns a copy whose pictures wait for the screen, or not. */
  public PlayerSettings withVsync(boolean vsync) {
    return Records.with(this, "vsync", vsync);
  }

  /** Returns a copy with texts of this size. */
  public PlayerSettings withTextSize(int textSize) {
    return Records.with(this, "textSize", textSize);
  }

  /** Returns a copy with these colours. */
  public PlayerSettings withPalette(Palette palette) {
    return Records.with(this, "palette", palette);
  }

  /** Returns a copy that draws other players' bodies at least this late. */
  public PlayerSettings withInterpolationMs(int interpolationMs) {
    return Records.with(this, "interpolationMs", interpolationMs);
  }

  /** Returns a copy with these keys for an action, which lose what they did before. */
  public PlayerSettings withKeys(KeyAction action, List<String> names) {
    Map<KeyAction, List<String>> changed = new EnumMap<>(KeyAction.class);
    keys.forEach(
        (other, bound) -> {
          List<String> left = new ArrayList<>(bound);
          left.removeAll(names);
          changed.put(other, left);
        });
    changed.put(action, names);
    return Records.with(this, "keys", changed);
  }

  /** Returns a copy with the default keys. */
  public PlayerSettings withDefaultKeys() {
    return Records.with(this, "keys", Map.of());
  }

  /** Returns a copy in which a server was played on last. */
  public PlayerSettings withRecent(String server) {
    return Records.with(this, "recent", first(server, recent, MAX_RECENT));
  }

  /** Returns a copy in which a server is a favourite, or isn't one any more if it was. */
  public PlayerSettings withFavouriteToggled(String server) {
    if (favourites.contains(server)) {
      List<String> left = new ArrayList<>(favourites);
      left.remove(server);
      return Records.with(this, "favourites", left);
    }
    return Records.with(this, "favourites", first(server, favourites, MAX_FAVOURITES));
  }

  private static List<String> first(String server, List<String> servers, int most) {
    List<String> changed = new ArrayList<>(servers);
    changed.remove(server);
    changed.add(0, server);
    return changed.subList(0, Math.min(most, changed.size()));
  }
}
