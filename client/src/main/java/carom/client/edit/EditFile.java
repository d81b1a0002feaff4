package carom.client.edit;

import carom.sim.level.Level;
import carom.text.FileErrors;
import carom.text.Json;
import carom.text.JsonException;
import carom.text.TextFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.Locale;

/** The file of a level that is edited: opened, written in one step, and watched for others. */
public final class EditFile {
  private static final String NEW =
      """
      {
        "name": "TITLE",
        "game": "platformer",
        "gravity": [0, -20],
        "bounds": { "min": [-20, -4], "max": [20, 14] },
        "spawns": [
          { "name": "player", "at": [-16, 1.2] },
          { "name": "flag", "at": [16, 1] }
        ],
        "statics": [
          { "name": "floor", "at": [0, -0.5], "shape": { "type": "box", "width": 40, "height": 1 } },
          { "name": "wall", "at": [-20.5, 7], "shape": { "type": "box", "width": 1, "height": 16 } },
          { "name": "wall", "at": [20.5, 7], "shape": { "type": "box", "width": 1, "height": 16 } }
        ]
      }
      """;

  private final Path path;
  private LevelSource onDisk; // as it was read or written; null for a new file
  private final LevelSource opened;

  /**
   * Opens a file, or begins a new level if there is none.
   *
   * @throws IOException if it can't be read or is no JSON; the message is for the player, with file
   *     and line
   */
  public EditFile(Path path) throws IOException {
    this.path = path;
    onDisk = read(path);
    opened = onDisk == null ? begun(path) : onDisk;
  }

  private static LevelSource read(Path path) throws IOException {
    try {
      LevelSource source = LevelSource.of(TextFile.read(path, Level.MAX_BYTES));
      if (source.root().kind != Json.Kind.OBJECT) {
        throw new IOException(path + ": the file holds " + source.root().kind.words + ", no level");
      }
      if (source.root().fields.containsKey("tiledversion")) {
        throw new IOException(
            path + " is a map of Tiled: edit it there, or convert it by 'carom level convert'");
      }
      return source;
    } catch (NoSuchFileException e) {
      return null;
    } catch (JsonException e) {
      throw new IOException(
          path + ":" + e.line() + ":" + e.column() + ": " + e.path() + e.getMessage(), e);
    } catch (IOException e) {
      String message = e.getMessage();
      throw message != null && message.startsWith(path.toString())
          ? e
          : new IOException(path + " can't be read: " + FileErrors.reason(e), e);
    }
  }

  private static LevelSource begun(Path path) throws IOException {
    Path folder = path.toAbsolutePath().getParent();
    if (folder == null || (Files.exists(folder) && !Files.isDirectory(folder))) {
      throw new IOException(path + " can't be a file: " + folder + " is no folder");
    }
    String name = path.getFileName().toString().replaceFirst("\\.json$", "");
    String title = name.replaceAll("[^\\p{L}\\p{N}]+", " ").strip();
    title = title.isEmpty() ? "Level" : title.substring(0, Math.min(60, title.length()));
    try {
      String begun = title.substring(0, 1).toUpperCase(Locale.ROOT) + title.substring(1);
      return LevelSource.of(NEW.replace("TITLE", begun));
    } catch (JsonException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  /** Returns where the file is. */
  public Path path() {
    return path;
  }

  /** Returns the level as it was opened. */
  public LevelSource opened() {
    return opened;
  }

  /** Returns whether a text would be lost: the file has another one. */
  public boolean isUnsaved(LevelSource source) {
    return !(onDisk == null ? opened : onDisk).isSame(source);
  }

  /** Returns whether another program has changed the file since it was read or written here. */
  public boolean isChanged() {
    try {
      byte[] now = TextFile.read(path, Level.MAX_BYTES).getBytes(StandardCharsets.UTF_8);
      return onDisk == null || !Arrays.equals(now, onDisk.bytes());
    } catch (NoSuchFileException e) {
      return false; // saving makes it anew
    } catch (IOException e) {
      return true;
    }
  }

  /**
   * Reads the file as it is now.
   *
   * @throws IOException if it can't be read or is no JSON; the message is for the player
   */
  public LevelSource reload() throws IOException {
    LevelSource now = read(path);
    if (now == null) {
      throw new IOException(path + " can't be read: there is no such file");
    }
    onDisk = now;
    return now;
  }

  /**
   * Writes the file in one step: after a crash it is the old one or the new one.
   *
   * @throws IOException if it can't be written; the message is for the player
   */
  public void save(LevelSource source) throws IOException {
    write(path.toAbsolutePath(), source);
    onDisk = source;
  }

  /**
   * Keeps a text that isn't saved beside the file.
   *
   * @return the end of a sentence that says where; empty if there was nothing to keep
   * @throws IOException if it can't be written; the message is for the player
   */
  public String rescue(LevelSource source) throws IOException {
    if (!isUnsaved(source)) {
      return "";
    }
    Path aside = path.toAbsolutePath().resolveSibling(path.getFileName() + ".unsaved");
    write(aside, source);
    return "; what wasn't saved is in " + aside;
  }

  private void write(Path whole, LevelSource source) throws IOException {
    Path fresh = whole.resolveSibling(whole.getFileName() + ".new");
    try {
      Files.createDirectories(whole.getParent());
      Files.write(fresh, source.bytes());
      Files.move(fresh, whole, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      Files.deleteIfExists(fresh);
      throw new IOException(path + " can't be written: " + FileErrors.reason(e), e);
    }
  }
}
