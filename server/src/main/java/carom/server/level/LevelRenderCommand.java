package carom.server.level;

import carom.options.BadFlag;
import carom.options.PictureSize;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.text.FileErrors;
import carom.tiled.TiledImport;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Runs {@code carom level render}, see {@link LevelPicture}. */
@Command(
    name = "render",
    sortOptions = false,
    usageHelpAutoWidth = true,
    mixinStandardHelpOptions = true,
    description = {"Draws a level as it begins to a PNG file, without a display.", ""},
    footer = {"", "Exit codes: 0 done, 2 bad flag, or a level that can't be used."})
final class LevelRenderCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Parameters(paramLabel = "FILE", description = "A level file, or a map of Tiled (.tmx, .tmj).")
  private Path file;

  @Option(names = "--out", paramLabel = "PNG", required = true, description = "The picture.")
  private Path out;

  @Option(
      names = "--size",
      paramLabel = "WxH",
      defaultValue = "1280x720",
      description = "Size of the picture, up to 7680x4320 (${DEFAULT-VALUE}).")
  private String size;

  LevelRenderCommand() {}

  @Override
  public Integer call() {
    try {
      PictureSize picture = PictureSize.parse(size);
      Level level = TiledImport.load(file);
      new LevelPicture(level, picture).save(out);
      return 0;
    } catch (LevelException | IllegalArgumentException e) {
      throw new BadFlag(spec.commandLine(), e.getMessage());
    } catch (IOException e) {
      throw new BadFlag(spec.commandLine(), "can't write " + out + ": " + FileErrors.reason(e));
    }
  }
}
