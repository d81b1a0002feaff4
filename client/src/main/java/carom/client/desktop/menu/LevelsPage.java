package carom.client.desktop.menu;

import carom.client.app.LocalGames;
import carom.text.FileErrors;
import com.badlogic.gdx.scenes.scene2d.ui.Label;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.scenes.scene2d.ui.TextField;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * Chooses a level to edit: a new one, one of the folder {@code levels}, or a copy of one that comes
 * with the program. Render thread only.
 */
final class LevelsPage implements Page {
  private static final int MAX_FILES = 100;
  private static final int MAX_NAME = 60;
  private static final int COPIES_IN_A_ROW = 4;
  private static final String ENDING = ".json";

  private final Widgets widgets;
  private final StartTarget target;
  private final LocalGames games;
  private final Path folder;
  private final Runnable rebuild;
  private TextField name;
  private String problem = "";

  /**
   * Creates a page.
   *
   * @param games knows the levels that come with the program; null without
   * @param present folder in which the folder of levels is, or begins
   * @param rebuild asks for the page to be built anew
   */
  LevelsPage(
      Widgets widgets, StartTarget target, LocalGames games, Path present, Runnable rebuild) {
    this.widgets = widgets;
    this.target = target;
    this.games = games;
    this.rebuild = rebuild;
    folder = present.resolve("levels");
  }

  @Override
  public void build(Table into) {
    into.defaults().space(8).left().growX();
    into.add(widgets.heading("Edit a level")).row();
    into.add(widgets.small("Name of a new level, in the folder levels; Enter begins it:")).row();
    name = widgets.field(name == null ? "" : name.getText(), MAX_NAME);
    into.add(name).height(Widgets.HEIGHT).row();
    into.add(widgets.button("Begin a new level", this::submit)).height(Widgets.HEIGHT).row();
    if (!problem.isEmpty()) {
      into.add(widgets.problem(problem)).row();
    }
    List<Path> files = files(folder);
    if (files.isEmpty()) {
      Label none = widgets.muted("No level yet in " + folder.toAbsolutePath());
      none.setWrap(true);
      into.add(none).row();
    }
    for (Path file : files) {
      into.add(widgets.row(file.getFileName().toString(), () -> open(file)))
          .height(Widgets.HEIGHT)
          .minWidth(0)
          .row();
    }
    if (games != null) {
      into.add(widgets.small("Or begin with a copy of a level that comes with Carom:")).row();
      Table copies = new Table();
      copies.defaults().height(Widgets.HEIGHT).space(8).growX().uniformX();
      for (String level : games.levels()) {
        copies.add(widgets.button(level, () -> copy(level)));
        if (copies.getChildren().size % COPIES_IN_A_ROW == 0) {
          copies.row();
        }
      }
      into.add(copies).row();
    }
  }

  /** Returns the level files of the folder by their names. */
  static List<Path> files(Path folder) {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .filter(file -> file.getFileName().toString().endsWith(ENDING))
          .filter(Files::isRegularFile)
          .sorted()
          .limit(MAX_FILES)
          .toList();
    } catch (IOException e) {
      return List.of(); // a folder that isn't there has nothing to offer
    }
  }

  @Override
  public void submit() {
    String typed = name.getText().strip();
    try {
      open(folder.resolve(typed.endsWith(ENDING) ? typed : typed + ENDING), typed);
    } catch (InvalidPathException e) {
      fail("\"" + typed + "\" can't be the name of a file");
    }
  }

  private void open(Path file, String typed) {
    if (typed.isEmpty()) {
      fail("Type a name first.");
    } else {
      open(file);
    }
  }

  private void copy(String level) {
    Path file = folder.resolve(level + "-copy" + ENDING);
    for (int i = 2; Files.exists(file); i++) {
      file = folder.resolve(level + "-copy-" + i + ENDING);
    }
    try {
      Files.createDirectories(folder);
      Files.write(file, games.level(level).source());
      open(file);
    } catch (IOException e) {
      fail("The copy can't be written: " + FileErrors.reason(e));
    }
  }

  private void open(Path file) {
    problem = target.edit(file);
    if (!problem.isEmpty()) {
      rebuild.run();
    }
  }

  private void fail(String text) {
    problem = text;
    rebuild.run();
  }

  @Override
  public void close() {
    problem = "";
  }
}
