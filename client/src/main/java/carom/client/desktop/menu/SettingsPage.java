package carom.client.desktop.menu;

import carom.client.look.Action;
import carom.client.settings.KeyAction;
import carom.client.settings.Palette;
import carom.client.settings.PlayerSettings;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.scenes.scene2d.Actor;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.scenes.scene2d.ui.TextField;
import java.util.List;
import java.util.function.Function;
import java.util.function.IntFunction;

/** The settings, each in a line. A change counts at once and is kept. Render thread only. */
final class SettingsPage implements Page {
  private static final float LABEL_WIDTH = 220;
  private static final int MAX_NAME_LENGTH = 32;

  private final Widgets widgets;
  private final SettingsHost host;
  private final MenuStage stage;
  private final Runnable rebuild;
  private TextField name;

  /** The action for which the player chooses a key, of the window or of the game; or null. */
  private Object waiting;

  private String problem = "";

  /**
   * Creates a page.
   *
   * @param stage shows the page, and hands over the key that the player chooses
   * @param rebuild asks for the page to be built anew
   */
  SettingsPage(Widgets widgets, SettingsHost host, MenuStage stage, Runnable rebuild) {
    this.widgets = widgets;
    this.host = host;
    this.stage = stage;
    this.rebuild = rebuild;
  }

  @Override
  public void build(Table into) {
    PlayerSettings s = host.settings();
    into.defaults().space(6).left();
    into.add(widgets.heading("Settings")).colspan(2).padBottom(8).row();
    name = widgets.field(name == null ? host.playerName() : name.getText(), MAX_NAME_LENGTH);
    line(into, "Name in games", name);
    line(into, "Colour of your body", ColourChooser.of(widgets, host, rebuild));
    steps(
        into,
        "Volume",
        s.get(PlayerSettings.VOLUME),
        5,
        0,
        100,
        v -> s.with(PlayerSettings.VOLUME, v),
        " %");
    steps(
        into,
        "Text size",
        s.get(PlayerSettings.TEXT_SIZE),
        25,
        75,
        200,
        v -> s.with(PlayerSettings.TEXT_SIZE, v),
        " %");
    steps(
        into,
        "Delay of others, at least",
        s.get(PlayerSettings.INTERPOLATION),
        25,
        0,
        300,
        v -> s.with(PlayerSettings.INTERPOLATION, v),
        " ms");
    line(
        into,
        "Window",
        widgets.button(
            s.get(PlayerSettings.FULLSCREEN)
                ? "fills the screen"
                : s.get(PlayerSettings.WINDOW).width()
                    + " x "
                    + s.get(PlayerSettings.WINDOW).height(),
            () -> change(WindowSizes.next(host.settings(), host.largestWindow()))));
    line(
        into,
        "Vsync",
        widgets.button(
            s.get(PlayerSettings.VSYNC) ? "on" : "off: sooner, and may tear",
            () ->
                change(host.settings().with(PlayerSettings.VSYNC, !s.get(PlayerSettings.VSYNC)))));
    Palette[] palettes = Palette.values();
    Palette next = palettes[(s.get(PlayerSettings.PALETTE).ordinal() + 1) % palettes.length];
    line(
        into,
        "Colours",
        widgets.button(
            s.get(PlayerSettings.PALETTE).label(),
            () -> change(host.settings().with(PlayerSettings.PALETTE, next))));
    KeyMap keys = host.keys();
    if (!keys.actions().isEmpty()) {
      into.add(widgets.muted("Keys of this game")).padTop(10).colspan(2).row();
    }
    for (Action action : keys.actions()) {
      for (Action.Binding binding : action.bindings()) {
        if (action.hasKeys()) {
          key(into, binding, binding.name(), keys.names(binding), n -> keys.withKeys(binding, n));
        }
      }
    }
    into.add(widgets.muted("Keys")).padTop(10).colspan(2).row();
    for (KeyAction action : KeyAction.values()) {
      key(
          into,
          action,
          action.label(),
          s.keys().get(action),
          n -> host.settings().withKeys(action, n));
    }
    line(
        into,
        "",
        widgets.button("All keys as at first", () -> change(host.settings().withDefaultKeys())));
    String said = problem.isEmpty() ? host.problem() : problem;
    if (!said.isEmpty()) {
      into.add(widgets.problem(said)).colspan(2).growX().row();
    }
  }

  private void line(Table into, String label, Actor value) {
    into.add(widgets.label(label)).width(LABEL_WIDTH);
    into.add(value).height(Widgets.HEIGHT).growX().row();
  }

  private void steps(
      Table into,
      String label,
      int value,
      int step,
      int min,
      int max,
      IntFunction<PlayerSettings> with,
      String unit) {
    Table row = new Table();
    Runnable less = () -> change(with.apply(Math.max(min, value - step)));
    Runnable more = () -> change(with.apply(Math.min(max, value + step)));
    row.add(widgets.button("-", less)).size(Widgets.HEIGHT);
    row.add(widgets.label(value + unit)).width(90).padLeft(14);
    row.add(widgets.button("+", more)).size(Widgets.HEIGHT);
    row.add().growX();
    line(into, label, row);
  }

  /** Adds a line for the keys of an action. */
  private void key(
      Table into,
      Object action,
      String label,
      List<String> keys,
      Function<List<String>, PlayerSettings> with) {
    boolean asks = action.equals(waiting);
    String text = asks ? "press a key ... (Esc: none)" : KeyMap.all(keys);
    line(into, label, widgets.button(text, () -> ask(action, with)));
  }

  private void ask(Object action, Function<List<String>, PlayerSettings> with) {
    waiting = action;
    stage.capture(
        key -> {
          waiting = null;
          String chosen = Keys.toString(key);
          boolean none = key == 0 || chosen == null;
          change(with.apply(none ? List.of() : List.of(chosen)));
        });
    rebuild.run();
  }

  private void change(PlayerSettings changed) {
    host.change(changed);
    rebuild.run();
  }

  @Override
  public void submit() {
    close();
    rebuild.run();
  }

  /** Keeps the name, unless it isn't allowed. */
  @Override
  public void close() {
    String entered = name == null ? host.playerName() : name.getText().strip();
    problem = "";
    try {
      host.playerName(entered);
    } catch (IllegalArgumentException e) {
      problem = "Not kept: " + e.getMessage() + ".";
    }
  }
}
