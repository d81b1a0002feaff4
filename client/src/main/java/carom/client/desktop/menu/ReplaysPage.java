package carom.client.desktop.menu;

import com.badlogic.gdx.scenes.scene2d.ui.Label;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.scenes.scene2d.ui.TextField;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/** Chooses a recording: those below the present folder, or any by its path. Render thread only. */
final class ReplaysPage implements Page {
  private static final int DEPTH = 3;
  private static final int MAX_FILES = 30;
  private static final int MAX_PATH_LENGTH = 1_000;

  private final Widgets widgets;
  private final StartTarget target;
  private final Path folder;
  private final Runnable rebuild;
  private TextField path;
  private String problem = "";

  /**
   * Creates a page.
   *
   * @param folder where to look for recordings
   * @param rebuild asks for the page to be built anew
   */
  ReplaysPage(Widgets widgets, StartTarget target, Path folder, Runnable rebuild) {
    this.widgets = widgets;
    this.target = target;
    this.folder = folder;
    this.rebuild = rebuild;
  }

  @Override
  public void build(Table into) {
    into.defaults().space(8).left().growX();
    into.add(widgets.heading("Replays")).row();
    into.add(widgets.small("A server records with --record; path of a recording:")).row();
    path = widgets.field(path == null ? "" : path.getText(), MAX_PATH_LENGTH);
    into.add(path).height(Widgets.HEIGHT).row();
    if (!problem.isEmpty()) {
      into.add(widgets.problem(problem)).row();
    }
    List<Path> files = recordings(folder);
    if (files.isEmpty()) {
      Label none = widgets.muted("No recording (*.carom) in " + folder.toAbsolutePath());
      none.setWrap(true);
      into.add(none).row();
    }
    for (Path file : files) {
      String name = folder.relativize(file).toString();
      into.add(widgets.row(name, () -> open(file))).height(Widgets.HEIGHT).minWidth(0).row();
    }
  }

  /** Returns the newest recordings in and below a folder, the newest first. */
  static List<Path> recordings(Path folder) {
    try (Stream<Path> files = Files.find(folder, DEPTH, (file, a) -> a.isRegularFile())) {
      return files
          .filter(file -> file.getFileName().toString().endsWith(".carom"))
          .sorted(Comparator.comparing(ReplaysPage::changed).reversed())
          .limit(MAX_FILES)
          .toList();
    } catch (IOException | UncheckedIOException e) {
      return List.of(); // a folder that can't be read has nothing to offer
    }
  }

  private static FileTime changed(Path file) {
    try {
      return Files.getLastModifiedTime(file);
    } catch (IOException e) {
      return FileTime.fromMillis(0);
    }
  }

  @Override
  public void submit() {
    try {
      open(Path.of(path.getText().strip()));
    } catch (InvalidPathException e) {
      problem = e.getMessage();
      rebuild.run();
    }
  }

  private void open(Path file) {
    problem = target.replay(file);
    if (!problem.isEmpty()) {
      rebuild.run();
    }
  }
}
