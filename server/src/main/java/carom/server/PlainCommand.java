package carom.server;

import carom.game.Games;
import carom.game.GamesOption;
import carom.options.BadFlag;
import carom.server.thin.GameClasses;
import carom.server.thin.plain.GameSources;
import carom.sim.Game;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.text.FileErrors;
import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/**
 * Runs {@code carom plain GAME}, which writes a game's messages as classes for stock KryoNet, see
 * docs/protocol/THIN.md.
 */
@Command(
    name = "plain",
    sortOptions = false,
    usageHelpAutoWidth = true,
    mixinStandardHelpOptions = true,
    description = {
      "Writes the messages of a game as Java classes, for programs with stock KryoNet.",
      ""
    },
    footer = {"", "Exit codes: 0 they are written, 2 bad flag, or a game that can't be read."})
final class PlainCommand implements Callable<Integer> {
  private static final String PACKAGE = "[a-z_][a-z0-9_]*(\\.[a-z_][a-z0-9_]*)*";
  private static final int TICK_RATE = 60;

  @Spec private CommandSpec spec;

  @Parameters(
      paramLabel = "GAME",
      description = "Jar of a game, or the name of an installed one, such as arena.")
  private String game;

  @Option(
      names = "--out",
      paramLabel = "FOLDER",
      required = true,
      description = "Folder of sources, such as src/main/java.")
  private Path folder;

  @Option(
      names = "--package",
      paramLabel = "NAME",
      description = "Package of the classes (the game's name).")
  private String inPackage;

  @Mixin
  @SuppressWarnings("unused") // picocli gives it the flag
  private GamesOption games;

  /** Creates a command that picocli has yet to fill in. */
  public PlainCommand() {}

  @Override
  public Integer call() {
    Game played = game();
    String name = inPackage == null ? packageOf(played.name()) : inPackage;
    if (!name.matches(PACKAGE)) {
      throw bad("--package=" + name + " is no name of a package, such as " + packageOf("my game"));
    }
    SimulationHost simulation =
        new SimulationHost(played, level(played), 1, TICK_RATE, Role.AUTHORITY);
    GameClasses classes = new GameClasses(simulation.messageKinds().own());
    if (classes.all().isEmpty()) {
      throw bad("game " + played.name() + " has no messages of its own; there is nothing to write");
    }
    Map<String, String> sources = GameSources.of(classes, name, played.name());
    Path to = folder.resolve(name.replace('.', '/'));
    try {
      Files.createDirectories(to);
      for (Map.Entry<String, String> source : sources.entrySet()) {
        Files.writeString(
            to.resolve(source.getKey() + ".java"), source.getValue(), StandardCharsets.US_ASCII);
      }
    } catch (IOException e) {
      throw bad("--out=" + folder + " can't be written: " + FileErrors.reason(e));
    }
    spec.commandLine()
        .getOut()
        .printf(
            Locale.ROOT,
            "%s: %s, classes=%d digest=%s%n",
            to,
            String.join(" ", sources.keySet()),
            sources.size(),
            classes.digest());
    spec.commandLine().getOut().flush();
    return 0;
  }

  private static String packageOf(String gameName) {
    String name = gameName.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]", "_");
    return Character.isDigit(name.charAt(0)) ? "_" + name : name;
  }

  private Game game() {
    Path jar = Path.of(game);
    if (!game.endsWith(".jar")) {
      try {
        return Games.create(game);
      } catch (IllegalArgumentException e) {
        throw bad(e.getMessage() + ", or name a jar");
      }
    }
    if (!Files.isRegularFile(jar)) {
      throw bad(game + " is no file");
    }
    try {
      // Not closed: the game loads classes until the program ends.
      ClassLoader loader =
          new URLClassLoader(new URL[] {jar.toUri().toURL()}, Games.class.getClassLoader());
      List<Game> games =
          ServiceLoader.load(Game.class, loader).stream()
              .filter(provider -> provider.type().getClassLoader() == loader)
              .map(ServiceLoader.Provider::get)
              .toList();
      if (games.size() != 1) {
        throw bad(game + " has games=" + games.size() + ", but must have one");
      }
      return games.get(0);
    } catch (IOException e) {
      throw bad(game + ": " + FileErrors.reason(e));
    }
  }

  private Level level(Game played) {
    String name = played.defaultLevel();
    try (InputStream in =
        played.getClass().getClassLoader().getResourceAsStream("levels/" + name + ".json")) {
      return in == null
          ? Level.builtIn(name)
          : Level.parse(name + ".json", in.readNBytes(Level.MAX_BYTES + 1));
    } catch (IOException | LevelException e) {
      throw bad("level " + name + " of game " + played.name() + ": " + e.getMessage());
    }
  }

  private BadFlag bad(String message) {
    return new BadFlag(spec.commandLine(), message);
  }
}
