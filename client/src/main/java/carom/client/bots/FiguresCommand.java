package carom.client.bots;

import carom.options.BadFlag;
import java.io.File;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/**
 * {@code carom-bots figures}: starts the program that measures, with all flags as they are. It runs
 * server and clients in one process, which no program of ours may; so it comes with the test kit,
 * in the installation's folder {@code lib/peers}.
 */
@Command(
    name = "figures",
    description = "Measures snapshots and prediction, and prints one table; see figures --help.")
final class FiguresCommand implements Callable<Integer> {
  private static final String PROGRAM = "carom.lab.figures.FiguresMain";

  @Parameters(hidden = true)
  private List<String> args = new ArrayList<>();

  @CommandLine.Spec private CommandLine.Model.CommandSpec spec;

  FiguresCommand() {}

  @Override
  public Integer call() throws IOException, InterruptedException, URISyntaxException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
    command.add("-cp");
    command.add(classPath());
    command.add(PROGRAM);
    command.addAll(args);
    return new ProcessBuilder(command).inheritIO().start().waitFor();
  }

  /** Ours, as in {@code ./gradlew figures}, or all jars of an installation. */
  private String classPath() throws URISyntaxException {
    Path mine =
        Path.of(FiguresCommand.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    Path peers = mine.resolveSibling("peers");
    if (Files.isDirectory(peers)) {
      return mine.resolveSibling("*") + File.pathSeparator + peers.resolve("*");
    }
    try {
      Class.forName(PROGRAM, false, FiguresCommand.class.getClassLoader());
    } catch (ClassNotFoundException e) {
      throw new BadFlag(
          spec.commandLine(),
          "figures: folder=" + peers + " is missing; it comes with ./gradlew installDist");
    }
    return System.getProperty("java.class.path");
  }
}
