package carom.server.level;

import carom.options.BadFlag;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** Runs {@code carom level}, whose commands work on level files. */
@Command(
    name = "level",
    mixinStandardHelpOptions = true,
    subcommands = {LevelCheckCommand.class, LevelRenderCommand.class, LevelConvertCommand.class},
    description = "Checks and draws level files, and makes them of maps of Tiled.")
public final class LevelCommand implements Runnable {
  @Spec private CommandSpec spec;

  /** Creates a command that picocli has yet to fill in. */
  public LevelCommand() {}

  @Override
  public void run() {
    throw new BadFlag(spec.commandLine(), "Which command? carom level --help shows them.");
  }
}
