package carom.server;

import carom.options.BadFlag;
import carom.options.LabCommand;
import carom.options.Subcommand;
import carom.options.VectorApi;
import carom.server.fleet.FleetCommand;
import carom.server.level.LevelCommand;
import java.io.PrintWriter;
import java.util.ServiceLoader;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/**
 * Runs {@code carom}: the tools for recorded games, servers and levels, the benchmark, what others
 * bring.
 */
@Command(
    name = "carom",
    mixinStandardHelpOptions = true,
    versionProvider = ServerMain.Version.class,
    subcommands = {
      ReplayCommand.class,
      HealthCommand.class,
      FleetCommand.class,
      PlainCommand.class,
      LevelCommand.class
    },
    description = "Tools of the Carom game server.")
public final class CaromMain implements Runnable {
  @Spec private CommandSpec spec;

  private CaromMain() {}

  /** Runs the command and exits the JVM with its exit code, which is 2 for bad flags. */
  public static void main(String[] args) {
    VectorApi.load();
    System.exit(commandLine().execute(args));
  }

  /**
   * Runs the command as {@link #main} does, but writes to the given writers and returns the code.
   */
  public static int run(PrintWriter out, PrintWriter err, String... args) {
    return commandLine().setOut(out).setErr(err).execute(args);
  }

  private static CommandLine commandLine() {
    CommandLine program = withBench(new CommandLine(new CaromMain()));
    LabCommand.add(
        program,
        "test",
        "Plays a game with bots over bad networks and says which rules it breaks; see test --help.",
        "carom.testkit.TestCommand");
    for (Subcommand further : ServiceLoader.load(Subcommand.class)) {
      program.addSubcommand(further.name(), further.command());
    }
    return BadFlag.explainedBy(program);
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
