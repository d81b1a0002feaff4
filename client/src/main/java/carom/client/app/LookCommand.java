package carom.client.app;

import carom.client.look.GameView;
import carom.client.look.LookFolder;
import carom.game.GameJars;
import carom.options.BadFlag;
import carom.text.FileErrors;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/**
 * Runs {@code carom look JAR}, which puts the look of a game's view into its jar as data, so that
 * servers can hand it to browsers. Without a jar, it takes the views of the class path.
 */
@Command(
    name = "look",
    mixinStandardHelpOptions = true,
    sortOptions = false,
    usageHelpAutoWidth = true,
    description = {
      "Puts the look that a game's view declares into its jar, for players in browsers.",
      ""
    },
    footer = {
      "",
      "Exit codes: 0 done, 2 bad flag, a jar that can't be read or written, or a view that fails."
    })
public final class LookCommand implements Callable<Integer> {
  @Parameters(
      paramLabel = "JAR",
      arity = "0..1",
      description = "Jar of a game with a view; without it, all games that ship, with --out.")
  private Path jar;

  @Option(
      names = "--out",
      paramLabel = "FOLDER",
      description = "Writes to this folder of resources instead of the jar.")
  private Path folder;

  @CommandLine.Spec private CommandLine.Model.CommandSpec spec;

  /** Creates a command that picocli has yet to fill in. */
  public LookCommand() {}

  /** Runs it alone, as the build does for the games that ship. */
  public static void main(String[] args) {
    System.exit(new CommandLine(new LookCommand()).execute(args));
  }

  @Override
  public Integer call() {
    if (jar == null && folder == null) {
      throw bad("name a jar, or a folder by --out for the looks of the games that ship");
    }
    if (jar != null && !Files.isRegularFile(jar)) {
      throw bad(jar + " is no file");
    }
    try {
      URL[] urls = jar == null ? new URL[0] : new URL[] {jar.toUri().toURL()};
      try (URLClassLoader loader = new URLClassLoader(urls, LookCommand.class.getClassLoader())) {
        List<GameView> views =
            ServiceLoader.load(GameView.class, loader).stream()
                .filter(view -> jar == null || view.type().getClassLoader() == loader)
                .map(ServiceLoader.Provider::get)
                .toList();
        if (views.isEmpty()) {
          throw bad(jar + " has no view: META-INF/services/carom.client.look.GameView names none");
        }
        write(views);
      }
    } catch (IOException | ServiceConfigurationError e) {
      throw bad(e instanceof IOException io ? FileErrors.reason(io) : e.getMessage());
    } catch (IllegalArgumentException e) {
      throw bad(e.getMessage());
    }
    return 0;
  }

  private void write(List<GameView> views) throws IOException {
    if (folder != null) {
      write(views, folder, folder.toString());
      return;
    }
    try (FileSystem inside = FileSystems.newFileSystem(jar)) {
      write(views, inside.getPath("/"), jar.toString());
    }
  }

  private void write(List<GameView> views, Path root, String name) throws IOException {
    for (GameView view : views) {
      int files = LookFolder.write(view, root);
      String place = GameJars.LOOKS + view.game();
      spec.commandLine().getOut().println(name + ": " + place + ", files=" + files);
    }
    spec.commandLine().getOut().flush();
  }

  private BadFlag bad(String problem) {
    return new BadFlag(spec.commandLine(), problem);
  }
}
