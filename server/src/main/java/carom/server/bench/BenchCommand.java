package carom.server.bench;

import static java.nio.charset.StandardCharsets.UTF_8;

import carom.sim.Suggestion;
import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.lang.module.ModuleFinder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/**
 * {@code carom-server bench}: measures the engine, each row in a process of its own, the engines of
 * a scene one right after the other.
 *
 * <p>The table goes to standard output, progress to standard error. Exit codes: 0 even if rows have
 * faults, which they tell; 1 if a file can't be written; 2 for bad flags.
 */
@Command(
    name = "bench",
    sortOptions = false,
    usageHelpAutoWidth = true,
    description = {"Measures the physics engine on its scenes, and the broadphase alone.", ""})
public final class BenchCommand implements Callable<Integer> {
  private static final String VECTOR = "vector";
  private static final String SCALAR = "scalar";
  private static final String VECTOR_MODULE = "jdk.incubator.vector";
  private static final double MAX_SECONDS = 3600;

  @Spec private CommandSpec spec;

  @Option(
      names = "--scenes",
      paramLabel = "A,B",
      split = ",",
      description = "Scenes by name; bp = the broadphase series (the benchmark set and bp).")
  private List<String> scenes;

  @Option(
      names = "--peers",
      paramLabel = "A,B",
      split = ",",
      description = "Other engines by name, or none (all on the class path).")
  private List<String> peers;

  @Option(
      names = "--kernels",
      paramLabel = "K",
      defaultValue = "both",
      description = "vector, scalar or both (${DEFAULT-VALUE}): with the Vector API or without.")
  private String kernels;

  @Option(
      names = "--warm-up",
      paramLabel = "S",
      defaultValue = "3",
      description = "Seconds of stepping before a row is measured, 0..3600 (${DEFAULT-VALUE}).")
  private double warmUpSeconds;

  @Option(
      names = "--cap",
      paramLabel = "S",
      defaultValue = "20",
      description =
          "Seconds after which slow engines stop early; their row says so, 0..3600"
              + " (${DEFAULT-VALUE}).")
  private double capSeconds;

  @Option(
      names = "--quick",
      description = "A first look: short warm-up, a quarter of the timed steps.")
  private boolean quick;

  @Option(
      names = "--json",
      paramLabel = "FILE",
      description = "Writes the rows, a JSON object per line.")
  private Path json;

  @Option(names = "--markdown", paramLabel = "FILE", description = "Writes the table in Markdown.")
  private Path markdown;

  @Option(
      names = {"-h", "--help"},
      usageHelp = true,
      description = "Shows this text.")
  @SuppressWarnings("unused") // picocli shows the help
  private boolean help;

  private final List<BenchRow> rows = new ArrayList<>();
  private volatile Process child;

  /** For picocli. */
  public BenchCommand() {}

  /**
   * Runs it alone, as {@code ./gradlew bench} does.
   *
   * @param args see {@code --help}
   */
  public static void main(String[] args) {
    CommandLine commandLine = new CommandLine(new BenchCommand());
    commandLine.setParameterExceptionHandler(
        (e, given) -> {
          PrintWriter err = e.getCommandLine().getErr();
          err.println("bench: " + e.getMessage());
          CommandLine.UnmatchedArgumentException.printSuggestions(e, err);
          err.println("Try 'bench --help'.");
          err.flush();
          return CommandLine.ExitCode.USAGE;
        });
    System.exit(commandLine.execute(args));
  }

  @Override
  public Integer call() throws InterruptedException {
    requireRange("--warm-up", warmUpSeconds);
    requireRange("--cap", capSeconds);
    List<BenchJob> jobs = jobs();
    List<String> others = others();
    List<String> kinds = kinds();
    PrintWriter out = spec.commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    Runtime.getRuntime().addShutdownHook(new Thread(this::endChild, "bench-stop"));
    try {
      write(); // a file that can't be written is told before the work, not after
      for (int i = 0; i < jobs.size(); i++) {
        BenchJob job = jobs.get(i);
        String progress = "[" + (i + 1) + "/" + jobs.size() + "] ";
        if (job.isBroadphase()) {
          for (String method : BenchJob.broadphases()) {
            measure(job, method, "", progress, err);
          }
          continue;
        }
        for (String kind : kinds) {
          measure(job, CaromEngine.NAME, kind, progress, err);
        }
        for (String peer : others) {
          measure(job, peer, "", progress, err);
        }
      }
    } catch (IOException e) {
      err.println("bench: " + e);
      err.flush();
      return CommandLine.ExitCode.SOFTWARE;
    }
    out.print(BenchTable.plain(rows));
    out.flush();
    return CommandLine.ExitCode.OK;
  }

  private void measure(BenchJob job, String engine, String kind, String progress, PrintWriter err)
      throws IOException, InterruptedException {
    err.print(progress + job.name() + ", " + (engine + " " + kind).strip() + ": ");
    err.flush();
    BenchRow row = runChild(job, engine, kind);
    rows.add(row);
    err.println(
        (row.isMeasured() ? String.format(Locale.ROOT, "%.3f ms ", row.medianMs()) : "")
            + row.fault());
    err.flush();
    write();
  }

  private BenchRow runChild(BenchJob job, String engine, String kind)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-Xms256m", "-Xmx2g", "-XX:+UseSerialGC"));
    if (kind.equals(VECTOR)) {
      command.addAll(List.of("--add-modules", VECTOR_MODULE));
    }
    command.addAll(List.of("-cp", System.getProperty("java.class.path")));
    command.addAll(List.of(BenchChild.class.getName(), engine, kind, job.name()));
    command.add(Double.toString(quick ? warmUpSeconds / 4 : warmUpSeconds));
    command.add(Double.toString(capSeconds));
    command.add(Boolean.toString(quick));
    File errors = File.createTempFile("carom-bench", ".err");
    try {
      Process started = new ProcessBuilder(command).redirectError(errors).start();
      child = started;
      started.getOutputStream().close();
      String last = "";
      for (String line : new String(started.getInputStream().readAllBytes(), UTF_8).split("\n")) {
        last = line.isBlank() ? last : line;
      }
      int status = started.waitFor();
      return status == 0
          ? BenchRow.ofJson(last)
          : BenchRow.failed(job.name(), engine, kind, fault(status, errors));
    } finally {
      child = null;
      Files.deleteIfExists(errors.toPath());
    }
  }

  /** The first line that looks like an exception. */
  private static String fault(int status, File errors) throws IOException {
    return Files.readAllLines(errors.toPath()).stream()
        .filter(line -> line.contains("Exception") || line.contains("Error"))
        .findFirst()
        .orElse("ended with status " + status);
  }

  private void endChild() {
    Process running = child;
    if (running != null) {
      running.destroyForcibly();
    }
  }

  private void write() throws IOException {
    if (json != null) {
      StringBuilder text = new StringBuilder();
      rows.forEach(row -> text.append(row.toJson()).append('\n'));
      Files.writeString(json, text);
    }
    if (markdown != null) {
      Files.writeString(markdown, BenchTable.markdown(rows));
    }
  }

  private List<BenchJob> jobs() {
    try {
      return scenes == null ? BenchJob.all() : BenchJob.of(scenes);
    } catch (IllegalArgumentException e) {
      throw bad("--scenes: " + e.getMessage());
    }
  }

  private List<String> others() {
    List<String> known = BenchChild.peers();
    if (peers == null) {
      return known;
    }
    if (peers.equals(List.of("none"))) {
      return List.of();
    }
    for (String peer : peers) {
      if (!known.contains(peer)) {
        throw bad(
            "--peers="
                + peer
                + Suggestion.didYouMean(peer, known)
                + (known.isEmpty()
                    ? ": this program brings no other engines; use ./gradlew bench"
                    : ": known are " + String.join(", ", known) + ", or none"));
      }
    }
    return peers;
  }

  private List<String> kinds() {
    if (!List.of(VECTOR, SCALAR, "both").contains(kernels)) {
      throw bad("--kernels=" + kernels + " is none of " + VECTOR + ", " + SCALAR + ", both");
    }
    boolean present = ModuleFinder.ofSystem().find(VECTOR_MODULE).isPresent();
    if (!present && kernels.equals(VECTOR)) {
      throw bad("--kernels=vector: this JVM has no module " + VECTOR_MODULE);
    }
    if (!kernels.equals("both")) {
      return List.of(kernels);
    }
    return present ? List.of(VECTOR, SCALAR) : List.of(SCALAR);
  }

  private void requireRange(String name, double value) {
    if (!(value >= 0 && value <= MAX_SECONDS)) {
      throw bad(name + "=" + value + " is outside 0.." + (int) MAX_SECONDS);
    }
  }

  private ParameterException bad(String message) {
    return new ParameterException(spec.commandLine(), message);
  }
}
