package carom.client.desktop;

import carom.client.desktop.KeyHints.Hint;
import carom.client.desktop.hud.Hud;
import carom.client.desktop.menu.KeyMap;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import carom.client.look.Action;
import carom.client.settings.KeyAction;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.Vector3;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The game's own actions and their keys beside the own body, in the first minute of play. A line
 * goes when the player has used it for a while. Render thread only.
 */
final class ActionHints {
  /** Time of play in which hints show, seconds. */
  static final float SHOWN_SECONDS = 60;

  /** Time for which a player holds the keys of an action until its hint goes, seconds. */
  private static final float KNOWN_SECONDS = 0.6f;

  private static final float FADES_SECONDS = 2;
  private static final float LINE = 21;
  private static final float PAD = 5;
  private static final float ASIDE = 12;

  /**
   * A line of the hints.
   *
   * @param keys names of keys or buttons
   * @param does what they do
   */
  private record Line(String keys, String does) {}

  private final KeyMap keys;
  private final Controls controls;
  private final Canvas canvas;
  private final Fonts fonts;
  private final Map<String, Float> used = new HashMap<>();
  private final List<Line> lines = new ArrayList<>();
  private final Color color = new Color();
  private List<Action> hinted = List.of();
  private float played;

  /** Creates hints that show from the next game on. The arguments stay the caller's property. */
  public ActionHints(KeyMap keys, Controls controls, Canvas canvas, Fonts fonts) {
    this.keys = keys;
    this.controls = controls;
    this.canvas = canvas;
    this.fonts = fonts;
  }

  /** Lets time pass in which the player plays; a game with other actions begins anew. */
  public void play(float seconds) {
    if (keys.actions() != hinted) {
      hinted = keys.actions();
      used.clear();
      played = 0;
    }
    played += seconds;
    for (Action action : hinted) {
      boolean down = false;
      for (Action.Binding binding : action.bindings()) {
        down |= keys.isDown(binding);
      }
      if (down) {
        used.merge(action.name(), seconds, Float::sum);
      }
    }
  }

  /** Returns the lines that the player still needs. */
  private List<Line> lines() {
    lines.clear();
    for (Action action : hinted) {
      if (used.getOrDefault(action.name(), 0f) < KNOWN_SECONDS) {
        String names = controls.isPadUsed() ? padNames(action) : keyNames(action);
        if (!names.isEmpty()) {
          lines.add(new Line(names, text(action)));
        }
      }
    }
    return lines;
  }

  private static String text(Action action) {
    List<Action.Binding> bindings = action.bindings();
    return bindings.size() == 1
        ? bindings.get(0).name()
        : bindings.get(0).name() + ", " + bindings.get(1).name();
  }

  private String keyNames(Action action) {
    StringBuilder names = new StringBuilder();
    for (Action.Binding binding : action.bindings()) {
      if (!keys.names(binding).isEmpty()) {
        names.append(names.length() == 0 ? "" : " ").append(keys.first(binding));
      }
    }
    String mouse = mouseNames(action);
    return names + (names.length() == 0 || mouse.isEmpty() ? "" : ", ") + mouse;
  }

  /** Returns all keys of the game's movements and actions, with the mouse's buttons. */
  static List<Hint> all(KeyMap keys) {
    List<Hint> hinted = new ArrayList<>();
    if (keys.actions().stream()
        .noneMatch(a -> a.kind() == Action.Kind.MOVE_X || a.kind() == Action.Kind.POINT)) {
      hinted.add(usualMoves(keys));
    }
    for (Action action : keys.actions()) {
      String mouse = mouseNames(action);
      for (Action.Binding binding : action.bindings()) {
        String names = keys.names(binding).isEmpty() ? "" : KeyMap.all(keys.names(binding));
        String all = names.isEmpty() || mouse.isEmpty() ? names + mouse : names + ", " + mouse;
        if (!all.isEmpty()) {
          hinted.add(new Hint(all, binding.name()));
        }
      }
    }
    return hinted;
  }

  private static Hint usualMoves(KeyMap keys) {
    String move =
        String.join(
            " ",
            keys.first(KeyAction.UP),
            keys.first(KeyAction.LEFT),
            keys.first(KeyAction.DOWN),
            keys.first(KeyAction.RIGHT));
    return new Hint(move + ", pad", "move");
  }

  /** Returns how an action is done by the mouse; empty for one that isn't. */
  private static String mouseNames(Action action) {
    List<String> names = new ArrayList<>(action.mouse());
    names.replaceAll(button -> button.equals("pointer") ? "mouse" : button + " click");
    return String.join(", ", names);
  }

  private static String padNames(Action action) {
    List<String> names = new ArrayList<>(action.pad());
    action.sticks().forEach(stick -> names.add(stick.equals("d-pad") ? stick : stick + " stick"));
    return String.join(", ", names);
  }

  /**
   * Draws the hints right of a disc, or left of it near the window's edge.
   *
   * @param at middle of the own body, points
   * @param radius of the own body, points
   */
  public void draw(Hud hud, Vector3 at, float radius) {
    float alpha = Math.min(1, (SHOWN_SECONDS - played) / FADES_SECONDS);
    if (alpha <= 0 || lines().isEmpty()) {
      return;
    }
    float keyWidth = 0;
    float textWidth = 0;
    for (Line line : lines) {
      keyWidth = Math.max(keyWidth, hud.width(fonts.small(), line.keys()));
      textWidth = Math.max(textWidth, hud.width(fonts.small(), line.does()));
    }
    float width = keyWidth + textWidth + 4 * PAD;
    boolean fits = at.x + radius + ASIDE + width < hud.windowWidth();
    float x = fits ? at.x + radius + ASIDE : at.x - radius - ASIDE - width;
    float top = at.y + lines.size() * LINE / 2;
    hud.beginFigures();
    for (int i = 0; i < lines.size(); i++) {
      color.set(UiColours.DIALOG).a *= alpha;
      canvas.rect(x, top - (i + 1) * LINE + 2, keyWidth + 2 * PAD, LINE - 4, color);
      color.set(UiColours.MUTED).a = alpha;
      canvas.frame(x, top - (i + 1) * LINE + 2, keyWidth + 2 * PAD, LINE - 4, 1, color);
    }
    canvas.end();
    hud.begin();
    for (int i = 0; i < lines.size(); i++) {
      float y = top - i * LINE - 6;
      color.set(UiColours.ACCENT).a = alpha;
      hud.floatingLeft(fonts.small(), lines.get(i).keys(), x + PAD, y, color);
      color.set(UiColours.TEXT).a = alpha;
      hud.floatingLeft(fonts.small(), lines.get(i).does(), x + keyWidth + 3 * PAD, y, color);
    }
    hud.end();
  }
}
