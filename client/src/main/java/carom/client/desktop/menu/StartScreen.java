package carom.client.desktop.menu;

import carom.client.app.LocalGames;
import carom.client.desktop.paint.LevelPictures;
import carom.client.desktop.paint.UiColours;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.ScreenAdapter;
import com.badlogic.gdx.scenes.scene2d.ui.Label;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.utils.Align;
import com.badlogic.gdx.utils.ScreenUtils;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The first screen: what to do at the left, the page of it at the right, or below where large texts
 * leave no place for both. It says, too, why the last visit to a server ended. Render thread only.
 */
public final class StartScreen extends ScreenAdapter {
  private static final float MENU_WIDTH = 250;
  private static final float PAGE_WIDTH = 720;
  private static final float PAD = 20;

  /** Least width of a window that has a place for menu and page side by side, points. */
  private static final float WIDE = 840;

  private static final int BUTTONS_IN_A_ROW = 3;

  /** Name of the page of recordings. */
  public static final String REPLAYS = "Replays";

  /** Name of the page of scenes. */
  public static final String SCENES = "Scenes";

  /** Name of the page of levels to edit. */
  public static final String LEVELS = "Edit a level";

  private final Widgets widgets;
  private final MenuStage stage = new MenuStage(this::submit, this::back);
  private final Map<String, Page> pages = new LinkedHashMap<>();
  private final JoinPage join;
  private final CreatePage create;
  private final Page quit;
  private Page page;
  private boolean stale = true;
  private boolean entering;

  /**
   * Creates a screen. The widgets and the host stay the property of the caller.
   *
   * @param games starts games on this machine; null when this build can't
   * @param pictures of levels; stays the property of the caller
   * @param server address that stands in the field to join
   */
  public StartScreen(
      Widgets widgets,
      SettingsHost host,
      StartTarget target,
      LocalGames games,
      LevelPictures pictures,
      String server) {
    this.widgets = widgets;
    Runnable rebuild = () -> stale = true;
    join = new JoinPage(widgets, host, target, server, rebuild);
    create = games == null ? null : new CreatePage(widgets, host, target, games, pictures, rebuild);
    if (create != null) {
      pages.put("Play here", create);
    }
    pages.put("Join a server", join);
    pages.put(REPLAYS, new ReplaysPage(widgets, target, Path.of(""), rebuild));
    pages.put(LEVELS, new LevelsPage(widgets, target, games, Path.of(""), rebuild));
    pages.put(SCENES, new ScenesPage(widgets, target));
    pages.put("Settings", new SettingsPage(widgets, host, stage, rebuild));
    quit = new QuitPage(widgets, this::back, target::quit);
    page = join;
    entering = true;
  }

  /** Shows the page of this name, {@link #REPLAYS}, {@link #LEVELS} or {@link #SCENES}. */
  public void open(String name) {
    turn(pages.get(name));
  }

  /** Shows why the player is here again; an empty text shows nothing. */
  public void message(String text) {
    turn(join);
    join.message(text);
  }

  /** Shows that no server was there, and offers to play without one. */
  public void offer(String reason) {
    message(reason);
    if (create != null) {
      join.offer(() -> turn(create));
    }
  }

  private void turn(Page next) {
    if (next != page) {
      page.close();
      page = next;
    }
    entering = true;
    stale = true;
  }

  private void submit() {
    page.submit();
  }

  /** Goes from a page to the first one, and from there to the question whether to quit. */
  private void back() {
    turn(page == join ? quit : join);
  }

  private Table titledMenu() {
    Table titled = new Table();
    Label title = widgets.title("CAROM");
    titled.add(title).height(64).center().row();
    titled.add(widgets.muted("multiplayer physics")).height(20).padBottom(22).row();
    titled.add(menu(1)).growX().row();
    titled.add(widgets.small("arrows, Tab, Enter, Esc")).height(Widgets.HEIGHT + 4).padTop(8);
    return titled;
  }

  /** Returns the buttons that lead to the pages, and out. */
  private Table menu(int columns) {
    Table menu = new Table();
    menu.defaults().height(Widgets.HEIGHT + (columns == 1 ? 4 : 0)).growX().uniformX().space(8);
    pages.forEach(
        (name, shown) -> {
          menu.add(widgets.button(shown == page ? "> " + name : name, () -> turn(shown)));
          if (menu.getChildren().size % columns == 0) {
            menu.row();
          }
        });
    menu.add(widgets.button(page == quit ? "> Quit" : "Quit", () -> turn(quit)));
    return menu;
  }

  private void build() {
    stale = false;
    Table content = new Table();
    page.build(content.top());
    Table panel = widgets.panel();
    panel.add(widgets.scroll(content)).grow().align(Align.topLeft);
    Table root = new Table();
    if (stage.width() < WIDE) {
      root.pad(PAD / 2);
      root.add(menu(BUTTONS_IN_A_ROW)).growX().padBottom(PAD / 2).row();
      root.add(panel.pad(PAD / 2)).grow();
    } else {
      root.pad(PAD);
      root.add(titledMenu()).width(MENU_WIDTH).top().padRight(PAD);
      root.add(panel).minWidth(MENU_WIDTH).prefWidth(PAGE_WIDTH).growY();
    }
    stage.show(root);
    if (entering) {
      entering = false;
      stage.top();
      stage.focus(pages.size() + 1); // the first part of the page
      if (page.entrance() != null) {
        stage.focus(page.entrance());
      }
    }
  }

  @Override
  public void show() {
    Gdx.input.setInputProcessor(stage.input());
  }

  @Override
  public void render(float deltaSeconds) {
    ScreenUtils.clear(UiColours.BACKDROP);
    stale |= page.update(System.nanoTime());
    if (stale) {
      build();
    }
    stage.draw(deltaSeconds);
  }

  @Override
  public void resize(int width, int height) {
    stage.resize(width, height, widgets.scale());
    stale = true;
  }

  @Override
  public void dispose() {
    page.close();
    stage.dispose();
  }
}
