package carom.client.desktop.menu;

import carom.client.LevelSender;
import carom.net.protocol.ServerMessage.LevelEntry;
import carom.net.protocol.ServerMessage.LevelList;
import carom.sim.level.Level;
import carom.text.FileErrors;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.scenes.scene2d.ui.TextButton;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.TimeUnit;

/**
 * The levels that players have sent to the server, among which those who play may choose, and the
 * player's own ones, which can be sent. Render thread only.
 */
final class PlayersLevelsPage implements Page {
  private static final Path FOLDER = Path.of("levels");
  private static final long ASK_NS = TimeUnit.SECONDS.toNanos(1);

  /** Knows the levels, and does what the player wants. */
  public interface Host {
    /** Asks the server for the levels. */
    void askForLevels();

    /** Returns the levels as they were told last; null before. */
    LevelList levels();

    /** Says which level the room is to play; an empty text for none. */
    void chooseLevel(String name);

    /** Begins to send a level of the player's; null if this game is on no server. */
    LevelSender send(byte[] level);
  }

  private final Widgets widgets;
  private final Host host;
  private LevelList shown;
  private List<Path> own = List.of();
  private boolean opened;
  private long askedNs;
  private LevelSender sender;
  private String progress = "";
  private String shownProgress = "";

  PlayersLevelsPage(Widgets widgets, Host host) {
    this.widgets = widgets;
    this.host = host;
  }

  @Override
  public void build(Table into) {
    shown = host.levels();
    into.defaults().space(6).left();
    into.add(widgets.heading("Levels of players")).padBottom(8).row();
    into.add(widgets.note(about())).growX().row();
    if (shown != null) {
      for (LevelEntry level : shown.levels()) {
        into.add(row(level)).height(Widgets.HEIGHT).growX().row();
      }
    }
    if (!own.isEmpty()) {
      into.add(widgets.muted("Send one of yours")).padTop(12).row();
      for (Path file : own) {
        String name = file.getFileName().toString();
        TextButton row = widgets.row(name, () -> send(file));
        row.setName(name);
        into.add(row).height(Widgets.HEIGHT).growX().row();
      }
    }
    if (!progress.isEmpty()) {
      into.add(widgets.note(progress)).growX().padTop(8).row();
    }
  }

  private String about() {
    if (shown == null) {
      return "Asking the server ...";
    }
    if (shown.levels().isEmpty()) {
      return "No player has sent a level to this server.";
    }
    return shown.mayChoose()
        ? "The room plays the one that more than half of you choose."
        : "The players of this room don't choose: ask who runs the server.";
  }

  private TextButton row(LevelEntry level) {
    String votes = level.votes() == 0 ? "" : level.votes() + (level.chosen() ? " with you" : "");
    String text = "%s     %s, by %s".formatted(level.name(), level.game(), level.author());
    TextButton row =
        widgets.row(
            text,
            widgets.mark(votes, level.chosen()),
            () -> {
              host.chooseLevel(level.chosen() ? "" : level.name());
              askedNs -= ASK_NS;
            });
    row.setName("level " + level.name());
    return row;
  }

  private void send(Path file) {
    if (sender == null) {
      try (InputStream in = Files.newInputStream(file)) {
        sender = host.send(in.readNBytes(Level.MAX_BYTES));
        progress = sender == null ? "You play on this machine, where your levels are." : "";
      } catch (IOException e) {
        progress = file + " can't be read: " + FileErrors.reason(e);
      }
    }
  }

  @Override
  public boolean update(long nowNs) {
    String before = shownProgress;
    boolean isNew = !opened;
    if (isNew) {
      own = LevelsPage.files(FOLDER);
    }
    if (isNew || nowNs - askedNs > ASK_NS) {
      opened = true;
      askedNs = nowNs;
      host.askForLevels();
    }
    if (sender != null) {
      sender.update(nowNs);
      progress = sender.text();
      sender = sender.isDone() ? null : sender;
    }
    shownProgress = progress;
    return isNew || !progress.equals(before) || !Objects.equals(shown, host.levels());
  }

  @Override
  public void close() {
    opened = false;
    progress = "";
    if (sender != null) {
      sender.close();
      sender = null;
    }
  }
}
