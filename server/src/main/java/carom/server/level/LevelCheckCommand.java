package carom.server.level;

import carom.game.GamesOption;
import carom.options.BadFlag;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.text.FileErrors;
import carom.tiled.TiledImport;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Runs {@code carom level check}, see {@link LevelCheck}. */
@Command(
    name = "check",
    sortOptions = false,
    usageHelpAutoWidth = true,
    mixinStandardHelpOptions = true,
    description = {
      "Reads and builds levels and steps them for two seconds, without a server, and says what is"
          + " wrong with them.",
      ""
    },
    footer = {
      "",
      "Exit codes: 0 they can be played, 1 one can't, or has warnings with --strict, 2 bad flag or"
          + " unreadable file."
    })
final class LevelCheckCommand implements Callable<Integer> {
  private static final int BAD = 1;

  @Spec private CommandSpec spec;

  @Parameters(
      arity = "1..*",
      paramLabel = "FILE",
      description = "Level files, or maps of Tiled (.tmx, .tmj).")
  private List<Path> files;

  @Mixin
  @SuppressWarnings("unused") // picocli gives it the flag
  private GamesOption games;

  @Option(names = "--strict", description = "Let warnings count as problems.")
  private boolean strict;

  LevelCheckCommand() {}

  @Override
  public Integer call() {
    PrintWriter out = spec.commandLine().getOut();
    int status = 0;
    for (Path file : files) {
      LevelCheck check = check(file);
      check.problems().forEach(out::println);
      check.warnings().forEach(warning -> out.println("warning: " + warning));
      boolean good = check.problems().isEmpty();
      if (!good || (strict && !check.warnings().isEmpty())) {
        status = BAD;
      }
      out.println(file + ": " + summary(check));
      out.flush();
    }
    return status;
  }

  private static String summary(LevelCheck check) {
    int warnings = check.warnings().size();
    int problems = check.problems().size();
    String after =
        warnings == 0 ? "" : ", " + warnings + (warnings == 1 ? " warning" : " warnings");
    return problems == 0
        ? "can be played" + after
        : "can't be played, " + problems + (problems == 1 ? " problem" : " problems") + after;
  }

  private LevelCheck check(Path file) {
    if (!TiledImport.isMap(file)) {
      return LevelCheck.of(file.toString(), read(file));
    }
    try {
      return LevelCheck.of(file + " as a level", TiledImport.load(file).source());
    } catch (LevelException e) {
      throw new BadFlag(spec.commandLine(), e.getMessage());
    }
  }

  private byte[] read(Path file) {
    try (InputStream in = Files.newInputStream(file)) {
      return in.readNBytes(Level.MAX_BYTES + 1);
    } catch (IOException e) {
      throw new BadFlag(spec.commandLine(), "can't read " + file + ": " + FileErrors.reason(e));
    }
  }
}
