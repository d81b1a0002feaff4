package carom.server;

import carom.options.BadFlag;
import carom.options.LabCommand;
import java.io.PrintWriter;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code carom}: tools around games that were played, and the benchmark. */
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
    System.exit(commandLine().execute(args));
  }

  /** As {@link #main}, but writes elsewhere and returns the exit code. */
  public static int run(PrintWriter out, PrintWriter err, String... args) {
    return commandLine().setOut(out).setErr(err).execute(args);
  }

  private static CommandLine commandLine() {
    return BadFlag.explainedBy(withBench(new CommandLine(new CaromMain())));
  }

  /** Adds the command that measures the engine. */
  static CommandLine withBench(CommandLine program) {
    LabCommand.add(
        program,
        "bench",
        "Measures the physics engine on its scenes, beside other engines; see bench --help.",
        "carom.lab.bench.BenchCommand");
    return program;
  }

  @Override
  public void run() {
    throw new BadFlag(spec.commandLine(), "Which command? carom --help shows them.");
  }
}
