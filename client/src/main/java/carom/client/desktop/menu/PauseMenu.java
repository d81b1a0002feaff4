package carom.client.desktop.menu;

import com.badlogic.gdx.InputProcessor;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.utils.Disposable;

/**
 * The menu over a game, which goes on meanwhile: back to the game, settings, rooms, leave, quit.
 * Render thread only.
 */
public final class PauseMenu implements Disposable {
  /** Receives what the player chooses. */
  public interface Actions {
    /** Closes the menu: keys are the game's again. */
    void resume();

    /** Shows the other rooms of the server. */
    void rooms();

    /** Leaves the game. */
    void leave();

    /** Quits the program. */
    void quit();
  }

  private static final float WIDTH = 320;
  private static final float SETTINGS_WIDTH = 560;

  private final Widgets widgets;
  private final Actions actions;
  private final MenuStage stage = new MenuStage(this::submit, this::back);
  private final SettingsPage settings;
  private boolean open;
  private boolean showsSettings;
  private boolean stale;

  /** Creates a menu that is closed. The widgets and the host stay the property of the caller. */
  public PauseMenu(Widgets widgets, SettingsHost host, Actions actions) {
    this.widgets = widgets;
    this.actions = actions;
    settings = new SettingsPage(widgets, host, stage, () -> stale = true);
  }

  /** Returns whether the menu shows and takes keys. */
  public boolean isOpen() {
    return open;
  }

  /** Shows the menu; returns what receives keys and mouse meanwhile. */
  public InputProcessor open() {
    open = true;
    showsSettings = false;
    stage.focus(0);
    stale = true;
    return stage.input();
  }

  private void close() {
    open = false;
    actions.resume();
  }

  private void submit() {
    if (showsSettings) {
      settings.submit();
    }
  }

  private void back() {
    if (showsSettings) {
      settings.close();
      turn(false);
    } else {
      close();
    }
  }

  private void turn(boolean toSettings) {
    showsSettings = toSettings;
    stage.focus(0);
    stale = true;
  }

  private void build() {
    stale = false;
    Table panel = widgets.panel();
    if (showsSettings) {
      Table page = new Table();
      settings.build(page.top());
      panel.add(widgets.scroll(page)).grow().row();
      panel.add(widgets.button("Back", this::back)).height(Widgets.HEIGHT).growX().padTop(10);
    } else {
      panel.defaults().height(Widgets.HEIGHT + 6).growX().space(8);
      panel.add(widgets.heading("The game goes on")).center().row();
      panel.add(widgets.button("Back to the game", this::close)).row();
      panel.add(widgets.button("Settings", () -> turn(true))).row();
      panel.add(widgets.button("Rooms", this::rooms)).row();
      panel.add(widgets.button("Leave the game", actions::leave)).row();
      panel.add(widgets.button("Quit Carom", actions::quit)).row();
    }
    Table root = new Table();
    if (showsSettings) {
      root.add(panel).width(SETTINGS_WIDTH).growY().pad(20);
    } else {
      root.add(panel).width(WIDTH);
    }
    stage.show(root);
  }

  private void rooms() {
    close();
    actions.rooms();
  }

  /** Draws the menu if it is open. */
  public void draw(float seconds) {
    if (!open) {
      return;
    }
    if (stale) {
      build();
    }
    stage.draw(seconds);
  }

  /** Fits the menu to the window, px. */
  public void resize(int width, int height) {
    stage.resize(width, height, widgets.scale());
    stale = true;
  }

  @Override
  public void dispose() {
    stage.dispose();
  }
}
