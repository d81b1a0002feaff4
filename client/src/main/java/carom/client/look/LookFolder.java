package carom.client.look;

import carom.game.GameFault;
import carom.game.GameJars;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/**
 * Lays out the look of a game as data: {@code carom/looks/GAME/look.json} and the pictures and
 * sounds that it names. So a server can hand it to painters in other languages, such as the page
 * that plays, without loading the view. The format is in docs/protocol/THIN.md.
 */
public final class LookFolder {
  private LookFolder() {}

  /**
   * Writes a view's look.
   *
   * @param root folder, or root of a jar, in which {@link GameJars#LOOKS} is made
   * @return the number of files
   * @throws IOException if a file of the view isn't there or is larger than {@link
   *     GameJars#MAX_LOOK_BYTES}, or the folder can't be written
   * @throws IllegalArgumentException if the view fails, with the place in it
   */
  public static int write(GameView view, Path root) throws IOException {
    ViewSetup setup = new ViewSetup();
    try {
      view.setUp(setup);
    } catch (RuntimeException | LinkageError e) {
      throw new IllegalArgumentException(
          "the view of game " + view.game() + " failed: " + GameFault.describe(e), e);
    }
    Map<String, String> names = names(setup);
    Map<String, byte[]> contents = new LinkedHashMap<>();
    for (Map.Entry<String, String> file : names.entrySet()) {
      contents.put(
          file.getValue(), LookFiles.read(view.getClass(), file.getKey(), GameJars.MAX_LOOK_BYTES));
    }
    contents.put("look.json", LookWriter.write(view.game(), setup, names));
    Path folder = root.resolve(GameJars.LOOKS).resolve(view.game());
    Files.createDirectories(folder);
    for (Map.Entry<String, byte[]> content : contents.entrySet()) {
      Files.write(folder.resolve(content.getKey()), content.getValue());
    }
    return contents.size();
  }

  /** Returns a name without folders for each file that the view names. */
  private static Map<String, String> names(ViewSetup setup) {
    Set<String> files = setup.pictures();
    for (Effect effect : setup.effects()) {
      if (effect instanceof SoundFile sound) {
        files.addAll(sound.files());
      }
    }
    if (!setup.music().isEmpty()) {
      files.add(setup.music());
    }
    Map<String, String> names = new LinkedHashMap<>();
    for (String file : files) {
      String last = file.substring(file.lastIndexOf('/') + 1).replaceAll("[^A-Za-z0-9._-]", "_");
      String name = last;
      for (int i = 2; names.containsValue(name); i++) {
        name = i + "-" + last;
      }
      names.put(file, name);
    }
    return names;
  }
}
