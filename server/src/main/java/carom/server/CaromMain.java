package carom.server;

import carom.options.BadFlag;
import java.io.PrintWriter;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code carom}: tools around games that were played. */
@Command(
    name = "carom",
    mixinStandardHelpOptions = true,
    versionProvider = ServerMain.Version.class,
    subcommands = ReplayCommand.class,
    description = "Tools of the Carom game server.")
public final class CaromMain implements Runnable {
  @Spec private CommandSpec spec;

  private CaromMain() {}

  /** Entry point; exits with the command's code, 2 on bad flags. */
  public static void main(String[] args) {
    System.exit(BadFlag.explainedBy(new CommandLine(new CaromMain())).execute(args));
  }

  /** As {@link #main}, but writes elsewhere and returns the exit code. */
  public static int run(PrintWriter out, PrintWriter err, String... args) {
    return BadFlag.explainedBy(new CommandLine(new CaromMain()))
        .setOut(out)
        .setErr(err)
        .execute(args);
  }

  @Override
  public void run() {
    throw new BadFlag(spec.commandLine(), "Which command? carom --help shows them.");
  }
}
