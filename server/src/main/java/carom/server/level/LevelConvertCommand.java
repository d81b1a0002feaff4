package carom.server.level;

import carom.options.BadFlag;
import carom.sim.level.LevelException;
import carom.text.FileErrors;
import carom.tiled.TiledImport;
import carom.tiled.TiledLevel;
import carom.tiled.TiledOptions;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Runs {@code carom level convert}, see {@link TiledImport}. */
@Command(
    name = "convert",
    sortOptions = false,
    usageHelpAutoWidth = true,
    mixinStandardHelpOptions = true,
    description = {
      "Makes a level file of a map of the editor Tiled (.tmx, .tmj, .json), and says what of the"
          + " map isn't in it.",
      ""
    },
    footer = {"", "Exit codes: 0 done, 2 bad flag, or a map that makes no level."})
final class LevelConvertCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Parameters(paramLabel = "MAP", description = "A map of Tiled, orthogonal.")
  private Path map;

  @Option(names = "--out", paramLabel = "FILE", required = true, description = "The level file.")
  private Path out;

  @Option(
      names = "--game",
      paramLabel = "NAME",
      defaultValue = "",
      description = "The level's game (the map's property game, or platformer).")
  private String game;

  @Option(
      names = "--name",
      paramLabel = "TEXT",
      defaultValue = "",
      description = "The level's name (the map's property name, or that of the file).")
  private String name;

  @Option(
      names = "--pixels-per-metre",
      paramLabel = "N",
      defaultValue = "0",
      description =
          "Pixels of a metre, 1..10000 (the map's property pixelsPerMetre, or the width of a"
              + " tile).")
  private double pixelsPerMetre;

  LevelConvertCommand() {}

  @Override
  public Integer call() {
    PrintWriter text = spec.commandLine().getOut();
    try {
      TiledLevel made = TiledImport.read(map, new TiledOptions(game, name, pixelsPerMetre));
      Files.write(out, made.level().source());
      made.skipped().forEach(skipped -> text.println("skipped: " + skipped));
      text.println(
          out
              + ": "
              + made.level().statics().size()
              + " statics, "
              + made.level().bodies().size()
              + " bodies, "
              + made.level().spawns().size()
              + " spawns; "
              + made.skipped().size()
              + " skipped");
      text.flush();
      return 0;
    } catch (LevelException e) {
      throw new BadFlag(spec.commandLine(), e.getMessage());
    } catch (IOException e) {
      throw new BadFlag(spec.commandLine(), "can't write " + out + ": " + FileErrors.reason(e));
    }
  }
}
