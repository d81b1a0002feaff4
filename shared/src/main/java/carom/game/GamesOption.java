package carom.game;

import carom.text.FileErrors;
import java.io.IOException;
import java.nio.file.Path;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The flag {@code --games} of every program that has to do with games. */
public final class GamesOption {
  @Spec(Spec.Target.MIXEE)
  private CommandSpec spec;

  /** Creates it, for picocli. */
  public GamesOption() {}

  @Option(
      names = "--games",
      paramLabel = "FOLDER",
      description =
          "Folder with game jars, besides the installation's games; a relative one is of the"
              + " working folder.")
  @SuppressWarnings("unused") // picocli calls it
  private void folder(Path folder) {
    try {
      GameJars.open(folder);
    } catch (IOException e) {
      throw new ParameterException(
          spec.commandLine(), "--games=" + folder + ": " + FileErrors.reason(e));
    }
  }
}
