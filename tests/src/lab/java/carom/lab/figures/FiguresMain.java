package carom.lab.figures;

import static java.nio.charset.StandardCharsets.UTF_8;

import carom.lab.measure.Figure;
import carom.text.Suggestion;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/**
 * Runs {@code carom-bots figures}: it runs the jobs one after the other, each in its own process,
 * and prints their figures as a table.
 */
@Command(
    name = "carom-bots figures",
    sortOptions = false,
    usageHelpAutoWidth = true,
    mixinStandardHelpOptions = true,
    description = {
      "Measures snapshots and prediction: what they cost, and how often they are right.",
      "Without flags everything but the crowd; takes a few minutes.",
      ""
    },
    footer = {
      "",
      "The table goes to standard output, or with --json the figures, one object per line.",
      "Exit codes: 0 all limits reached, 1 one missed or not measured, 2 bad flag."
    })
public final class FiguresMain implements Callable<Integer> {
  @Option(
      names = "--only",
      paramLabel = "JOB",
      split = ",",
      description =
          "these jobs: snapshots, naive, budget, perfect, alone, push, forces, rocket, machines,"
              + " feel, rollback, encode, rest, entry, crowd, codec")
  private List<String> only = new ArrayList<>();

  @Option(
      names = "--crowd",
      description = "also a server and 500 bots in two processes: a minute of the whole machine")
  private boolean crowd;

  @Option(names = "--quick", description = "roughly, in a fraction of the time")
  private boolean quick;

  @Option(names = "--json", description = "print JSON instead of the table")
  private boolean json;

  @Option(names = "--markdown", paramLabel = "FILE", description = "write the table there, too")
  private Path markdown;

  @Option(names = "--child", paramLabel = "JOB", hidden = true)
  private String child;

  @Spec private CommandSpec spec;

  /** Creates the command, for picocli. */
  public FiguresMain() {}

  /** Runs the command and exits the JVM with its exit code. */
  public static void main(String[] args) {
    System.exit(run(args));
  }

  /** Runs the command as {@link #main} does, but returns the exit code. */
  public static int run(String... args) {
    return new CommandLine(new FiguresMain()).execute(args);
  }

  @Override
  public Integer call() throws Exception {
    if (child != null) {
      FigureJob.ALL
          .get(child)
          .measure(quick)
          .forEach(f -> System.out.println(f.of(child).toJson()));
      return 0;
    }
    for (String job : only) {
      if (!FigureJob.ALL.containsKey(job)) {
        throw new ParameterException(
            spec.commandLine(),
            "--only=" + job + " is no job" + Suggestion.didYouMean(job, FigureJob.ALL.keySet()));
      }
    }
    List<Figure> figures = new ArrayList<>();
    for (String job : FigureJob.ALL.keySet()) {
      boolean wanted = only.isEmpty() ? !job.equals(FigureJob.CROWD) : only.contains(job);
      if (wanted || crowd && job.equals(FigureJob.CROWD)) {
        System.err.println(job + " ...");
        figures.addAll(measure(job));
      }
    }
    if (json) {
      figures.forEach(figure -> System.out.println(figure.toJson()));
    } else {
      System.out.print(FigureTable.of(figures));
    }
    if (markdown != null) {
      Files.writeString(markdown, FigureTable.of(figures));
    }
    return figures.stream().allMatch(Figure::reached) ? 0 : 1;
  }

  private List<Figure> measure(String job) throws InterruptedException {
    List<Figure> figures = new ArrayList<>();
    String[] args =
        quick ? new String[] {"--quick", "--child", job} : new String[] {"--child", job};
    try {
      Process process = Children.start(null, FiguresMain.class, args);
      try (BufferedReader lines = process.inputReader(UTF_8)) {
        for (String line; (line = lines.readLine()) != null; ) {
          if (line.startsWith("{\"job\":")) {
            figures.add(Figure.ofJson(line));
          }
        }
      }
      int exit = process.waitFor();
      if (exit != 0 || figures.isEmpty()) {
        figures.add(Figure.failed(job, "its process ended with exit code " + exit));
      }
    } catch (IOException e) {
      figures.add(Figure.failed(job, "its process could not be run: " + e.getMessage()));
    }
    return figures;
  }
}
