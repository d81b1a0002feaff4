package carom.client.desktop.menu;

import carom.client.settings.PlayerSettings;
import carom.sim.message.PlayerColour;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.scenes.scene2d.ui.TextButton;
import java.util.Arrays;
import java.util.List;

/** Chooses the colour of the player's body: the present one between two buttons. */
final class ColourChooser {
  private static final List<PlayerColour> ALL = Arrays.asList(PlayerColour.values());
  private static final float LABEL_WIDTH = 120;

  private ColourChooser() {}

  /**
   * Returns the buttons and the colour.
   *
   * @param changed runs after a choice, and should show the page anew
   */
  static Table of(Widgets widgets, SettingsHost host, Runnable changed) {
    PlayerColour shown = host.settings().get(PlayerSettings.COLOUR);
    Table row = new Table();
    row.add(step("<", -1, widgets, host, changed)).size(Widgets.HEIGHT);
    if (shown.rgb() >= 0) {
      row.add(widgets.swatch(shown.rgb())).size(Widgets.HEIGHT / 2).padLeft(14);
    }
    row.add(widgets.label(shown.label())).width(LABEL_WIDTH).padLeft(14);
    row.add(step(">", 1, widgets, host, changed)).size(Widgets.HEIGHT);
    row.add().growX();
    return row;
  }

  private static TextButton step(
      String text, int by, Widgets widgets, SettingsHost host, Runnable changed) {
    return widgets.button(
        text,
        () -> {
          int next = ALL.indexOf(host.settings().get(PlayerSettings.COLOUR)) + by + ALL.size();
          host.change(host.settings().with(PlayerSettings.COLOUR, ALL.get(next % ALL.size())));
          changed.run();
        });
  }
}
