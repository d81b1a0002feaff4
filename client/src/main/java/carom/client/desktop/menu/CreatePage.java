package carom.client.desktop.menu;

import carom.client.app.LocalGames;
import carom.client.desktop.paint.LevelPictures;
import carom.game.Games;
import carom.sim.level.Level;
import com.badlogic.gdx.scenes.scene2d.Actor;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.scenes.scene2d.ui.TextButton;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Starts a game on this machine, alone, with bots or for others. Render thread only. */
final class CreatePage implements Page {
  private static final float LABEL_WIDTH = 220;
  private static final int USUAL_BOTS = 5;
  private static final int CARDS_IN_A_ROW = 3;

  /** Longest side of a level in which the players of one machine meet, m. */
  private static final float MOST_METRES = 250;

  private final Widgets widgets;
  private final SettingsHost host;
  private final StartTarget target;
  private final LocalGames games;
  private final LevelPictures pictures;
  private final Runnable rebuild;
  private final Map<String, Level> known = new HashMap<>();
  private final List<String> levels;
  private String level;
  private int bots = USUAL_BOTS;
  private boolean open;
  private String problem = "";

  /**
   * Creates a page.
   *
   * @param rebuild asks for the page to be built anew
   */
  CreatePage(
      Widgets widgets,
      SettingsHost host,
      StartTarget target,
      LocalGames games,
      LevelPictures pictures,
      Runnable rebuild) {
    this.widgets = widgets;
    this.host = host;
    this.target = target;
    this.games = games;
    this.pictures = pictures;
    this.rebuild = rebuild;
    levels = games.levels().stream().filter(name -> isSmall(level(name))).toList();
    level = levels.get(0);
  }

  @Override
  public void build(Table into) {
    into.defaults().space(8).left();
    into.add(widgets.heading("Play on this machine")).colspan(2).row();
    into.add(widgets.primary("Start", this::submit))
        .colspan(2)
        .height(Widgets.HEIGHT + 8)
        .growX()
        .row();
    if (!problem.isEmpty()) {
      into.add(widgets.problem(problem)).colspan(2).growX().row();
    }
    line(into, "Colour of your body", ColourChooser.of(widgets, host, rebuild));
    line(into, "Bots", steps());
    line(
        into,
        "Others on the network",
        widgets.button(
            open ? "may join" : "can't join",
            () -> {
              open = !open;
              rebuild.run();
            }));
    into.add(widgets.muted("Level")).padTop(8);
    into.add(widgets.note(Games.create(level(level).gameName()).description())).growX().row();
    Table cards = new Table();
    cards.defaults().space(8).growX().uniformX();
    for (int i = 0; i < levels.size(); i++) {
      cards.add(card(levels.get(i)));
      if (i % CARDS_IN_A_ROW == CARDS_IN_A_ROW - 1) {
        cards.row();
      }
    }
    into.add(cards).colspan(2).growX().row();
  }

  /** Returns a button that shows a level, and a line about it. */
  private TextButton card(String name) {
    Level shown = level(name);
    return widgets.card(
        pictures.has(shown) ? pictures.of(shown) : null,
        (name.equals(level) ? "> " : "") + name,
        about(shown),
        () -> choose(name));
  }

  /** Draws one level after the other, so that the page shows at once. */
  @Override
  public boolean update(long nowNs) {
    for (String name : levels) {
      if (!pictures.has(level(name))) {
        pictures.of(level(name));
        return true;
      }
    }
    return false;
  }

  private Level level(String name) {
    return known.computeIfAbsent(name, games::level);
  }

  /**
   * Returns whether few players don't lose each other in a level, as they do in a field for
   * hundreds.
   */
  private static boolean isSmall(Level level) {
    Level.Bounds b = level.bounds();
    return Math.max(b.maxX() - b.minX(), b.maxY() - b.minY()) <= MOST_METRES;
  }

  /** Returns a level's name and how large it is. */
  private static String about(Level level) {
    Level.Bounds bounds = level.bounds();
    return String.format(
        Locale.ROOT,
        "%s, %.0f x %.0f m",
        level.name(),
        bounds.maxX() - bounds.minX(),
        bounds.maxY() - bounds.minY());
  }

  private void choose(String name) {
    level = name;
    rebuild.run();
  }

  private Table steps() {
    Table row = new Table();
    row.add(widgets.button("-", () -> bots(bots - 1))).size(Widgets.HEIGHT);
    row.add(widgets.label(Integer.toString(bots))).width(60).padLeft(14);
    row.add(widgets.button("+", () -> bots(bots + 1))).size(Widgets.HEIGHT);
    row.add().growX();
    return row;
  }

  private void bots(int wanted) {
    bots = Math.max(0, Math.min(LocalGames.MAX_BOTS, wanted));
    rebuild.run();
  }

  private void line(Table into, String label, Actor value) {
    into.add(widgets.label(label)).width(LABEL_WIDTH);
    into.add(value).height(Widgets.HEIGHT).growX().row();
  }

  @Override
  public void close() {
    problem = "";
  }

  @Override
  public void submit() {
    try {
      problem = "";
      target.create(new LocalGames.GameChoice(level, bots, open));
    } catch (IllegalStateException e) {
      problem = e.getMessage();
      rebuild.run();
    }
  }
}
