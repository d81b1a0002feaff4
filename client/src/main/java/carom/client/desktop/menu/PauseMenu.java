package carom.client.desktop.menu;

import carom.net.protocol.ServerMessage.BestList;
import com.badlogic.gdx.InputProcessor;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.utils.Disposable;
import java.util.List;

/**
 * The menu over a game, which goes on meanwhile: back to the game, settings, the best, levels of
 * players, rooms, a link for friends, leave, quit. Render thread only.
 */
public final class PauseMenu implements Disposable {
  /** Receives what the player chooses. */
  public interface Actions extends PlayersLevelsPage.Host {
    /** Closes the menu: keys are the game's again. */
    void resume();

    /** Asks the server for the best lists. */
    void askForBest();

    /** Returns the best lists as they were told last; null before. */
    List<BestList> best();

    /** Shows the other rooms of the server. */
    void rooms();

    /** Returns the link by which a browser plays in this room, or an empty string. */
    String playLink();

    /** Leaves the game. */
    void leave();

    /** Quits the program. */
    void quit();
  }

  private static final float WIDTH = 320;
  private static final float PAGE_WIDTH = 560;

  private final Widgets widgets;
  private final Actions actions;
  private final MenuStage stage = new MenuStage(this::submit, this::back);
  private final Page settings;
  private final Page best;
  private final Page levels;

  /** The page that shows, or null for the choice among them. */
  private Page page;

  private boolean open;
  private boolean stale;

  /** Creates a menu that is closed. The widgets and the host stay the property of the caller. */
  public PauseMenu(Widgets widgets, SettingsHost host, Actions actions) {
    this.widgets = widgets;
    this.actions = actions;
    settings = new SettingsPage(widgets, host, stage, () -> stale = true);
    best = new BestPage(widgets, actions::askForBest, actions::best);
    levels = new PlayersLevelsPage(widgets, actions);
  }

  /** Returns whether the menu shows and takes keys. */
  public boolean isOpen() {
    return open;
  }

  /** Shows the menu; returns what receives keys and mouse meanwhile. */
  public InputProcessor open() {
    open = true;
    turn(null);
    return stage.input();
  }

  private void close() {
    open = false;
    actions.resume();
  }

  private void submit() {
    if (page != null) {
      page.submit();
    }
  }

  private void back() {
    if (page != null) {
      turn(null);
    } else {
      close();
    }
  }

  private void turn(Page to) {
    if (page != null) {
      page.close();
    }
    page = to;
    stage.focus(0);
    stale = true;
  }

  private void build() {
    stale = false;
    Table panel = widgets.panel();
    if (page != null) {
      Table content = new Table();
      page.build(content.top());
      panel.add(widgets.scroll(content)).grow().row();
      panel.add(widgets.button("Back", this::back)).height(Widgets.HEIGHT).growX().padTop(10);
    } else {
      panel.defaults().height(Widgets.HEIGHT + 6).growX().space(8);
      panel.add(widgets.heading("The game goes on")).center().row();
      panel.add(widgets.button("Back to the game", this::close)).row();
      panel.add(widgets.button("Settings", () -> turn(settings))).row();
      panel.add(widgets.button("The best", () -> turn(best))).row();
      panel.add(widgets.button("Levels of players", () -> turn(levels))).row();
      panel.add(widgets.button("Rooms", this::rooms)).row();
      if (!actions.playLink().isEmpty()) {
        panel.add(widgets.button("Play in a browser", this::link)).row();
      }
      panel.add(widgets.button("Leave the game", actions::leave)).row();
      panel.add(widgets.button("Quit Carom", actions::quit)).row();
    }
    Table root = new Table();
    if (page == settings || page == best) {
      root.add(panel).width(PAGE_WIDTH).growY().pad(20);
    } else {
      root.add(panel).width(WIDTH);
    }
    stage.show(root);
  }

  private void link() {
    turn(new LinkPage(widgets, actions.playLink(), () -> stale = true));
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
    stale |= page != null && page.update(System.nanoTime());
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
    turn(null);
    stage.dispose();
  }
}
