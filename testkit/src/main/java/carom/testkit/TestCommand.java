package carom.testkit;

import carom.game.Games;
import carom.game.GamesOption;
import carom.options.BadFlag;
import carom.options.NetworkConditions.Preset;
import carom.sim.Game;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.tiled.TiledImport;
import ch.qos.logback.classic.Logger;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import org.slf4j.LoggerFactory;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Runs {@code carom test}, see {@link GameTest}. */
@Command(
    name = "test",
    sortOptions = false,
    usageHelpAutoWidth = true,
    mixinStandardHelpOptions = true,
    description = {
      "Plays a game with bots over bad networks, without sockets and faster than real time, and"
          + " says which rules it breaks.",
      ""
    },
    footer = {"", "Exit codes: 0 no rule is broken, 1 a rule is broken, 2 bad flag."})
public final class TestCommand implements Callable<Integer> {
  private static final int BROKEN = 1;
  private static final int MOST_PLAYERS = 64;

  @Spec private CommandSpec spec;

  @Parameters(paramLabel = "GAME", description = "Name of the game, such as arena.")
  private String game;

  @Option(
      names = "--level",
      paramLabel = "LEVEL",
      description = "Level file, or name of a built-in level (the game's own).")
  private String level;

  @Option(
      names = "--network",
      paramLabel = "NAME",
      split = ",",
      description = "Networks: ${COMPLETION-CANDIDATES} (wifi,mobile,transatlantic,bad).")
  private List<Preset> networks =
      List.of(Preset.WIFI, Preset.MOBILE, Preset.TRANSATLANTIC, Preset.BAD);

  @Option(
      names = "--players",
      paramLabel = "N",
      defaultValue = "3",
      description = "Players who play together, 1..64; each network is also played alone (3).")
  private int players;

  @Option(
      names = "--seconds",
      paramLabel = "S",
      defaultValue = "20",
      description = "Length of each play in virtual time, 1..3600 (20).")
  private double seconds;

  @Option(
      names = "--seed",
      paramLabel = "N",
      defaultValue = "1",
      description = "Seed of networks and bots; equal seeds give equal plays (1).")
  private long seed;

  @Mixin
  @SuppressWarnings("unused") // picocli gives it the flag
  private GamesOption games;

  @Option(names = "--json", description = "Print one line of JSON.")
  private boolean json;

  /** Creates the command. */
  public TestCommand() {}

  @Override
  public Integer call() {
    if (players < 1 || players > MOST_PLAYERS) {
      throw bad("--players=" + players + " is outside 1.." + MOST_PLAYERS);
    }
    if (!(seconds >= 1 && seconds <= 3_600)) {
      throw bad("--seconds=" + seconds + " is outside 1..3600");
    }
    Supplier<Game> made = made();
    Level played = level(made.get());
    Logger log = (Logger) LoggerFactory.getLogger(Logger.ROOT_LOGGER_NAME);
    ch.qos.logback.classic.Level before = log.getLevel();
    log.setLevel(ch.qos.logback.classic.Level.OFF); // the report has all of it, once
    GameReport report;
    try {
      report = GameTest.run(made, played, networks, players, seconds, seed);
    } finally {
      log.setLevel(before);
    }
    spec.commandLine().getOut().println(json ? report.json() : report.text());
    spec.commandLine().getOut().flush();
    return report.broken().isEmpty() ? 0 : BROKEN;
  }

  private Supplier<Game> made() {
    try {
      return Games.supplier(game);
    } catch (IllegalArgumentException e) {
      throw bad(e.getMessage());
    }
  }

  private Level level(Game played) {
    try {
      return checked(
          level != null && Files.isRegularFile(Path.of(level))
              ? TiledImport.load(Path.of(level))
              : Level.builtIn(level == null ? played.defaultLevel() : level));
    } catch (LevelException e) {
      throw bad(e.getMessage());
    }
  }

  private Level checked(Level found) {
    if (!found.gameName().equals(game)) {
      throw bad("level \"" + found.name() + "\" is of game " + found.gameName() + ", not " + game);
    }
    return found;
  }

  private BadFlag bad(String message) {
    return new BadFlag(spec.commandLine(), message);
  }
}
