package carom.lab.bench;

import carom.lab.measure.BenchJob;
import carom.lab.measure.BenchRow;
import carom.lab.measure.Entrant;
import carom.options.BadFlag;
import carom.text.Suggestion;
import java.io.IOException;
import java.io.PrintWriter;
import java.lang.module.ModuleFinder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.CopyOnWriteArrayList;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/**
 * Runs {@code carom bench} and {@code carom-server bench}, which measure the engine. Each row is
 * measured in its own process, and the entrants of a scene take turns.
 *
 * <p>The tables go to standard output and the progress to standard error. With {@code --json} and
 * no file, the rows go to standard output and the tables to standard error. Exit codes: 0, also if
 * rows have faults, which the rows state; 1 if a file can't be written; 2 for bad flags.
 */
@Command(
    name = "bench",
    sortOptions = false,
    usageHelpAutoWidth = true,
    description = {
      "Measures the physics engine on its scenes, beside other engines, and its parts alone.",
      "Every row is measured in a process of its own, the entrants of a scene in turns;",
      "all of it takes about an hour.",
      ""
    },
    footer = {
      "",
      "Progress goes to standard error. ! marks figures of a run that failed its sanity gate.",
      "Exit codes: 1 a file can't be written, 2 bad flag."
    })
public final class BenchCommand implements Callable<Integer> {
  private static final String VECTOR = "vector";
  private static final String SCALAR = "scalar";
  private static final String VECTOR_MODULE = "jdk.incubator.vector";
  private static final double MAX_SECONDS = 3600;
  private static final int MAX_THREADS = 64;
  private static final String STANDARD_OUTPUT = "-";

  @Spec private CommandSpec spec;

  @Option(
      names = "--scenes",
      paramLabel = "A,B",
      split = ",",
      description =
          "What to measure, by name: a scene of the library or a row, or the groups scenes, state,"
              + " pairs (the engine's pair search within its steps), bp (its tree alone, beside"
              + " other structures) and rebuild (all of them and startup_10k).")
  private List<String> scenes;

  @Option(
      names = "--peers",
      paramLabel = "A,B",
      split = ",",
      description =
          "Other engines by name, or none (all there are: those that ./gradlew bench has on the"
              + " class path, or the jars in lib/lab/peers of an installation).")
  private List<String> peers;

  @Option(
      names = "--external",
      paramLabel = "NAME=PROGRAM",
      description =
          "A program that measures another engine, for instance a native one: it gets the scene's"
              + " name and files, and takes its turns as docs/lab/BENCHMARKS.md tells. Repeatable.")
  private Map<String, Path> external = Map.of();

  @Option(
      names = "--kernels",
      paramLabel = "K",
      defaultValue = "both",
      description = "vector, scalar or both (${DEFAULT-VALUE}): with the Vector API or without.")
  private String kernels;

  @Option(
      names = "--threads",
      paramLabel = "N,M",
      split = ",",
      description =
          "How many threads step a world, 1..64; a row for each. Several are timed by the clock"
              + " (1,2 where there are two processors).")
  private List<Integer> threads;

  @Option(
      names = "--warm-up",
      paramLabel = "S",
      defaultValue = "3",
      description =
          "Seconds of stepping before a row is measured, at least; it goes on until the scene no"
              + " longer gets faster, 0..3600 (${DEFAULT-VALUE}).")
  private double warmUpSeconds;

  @Option(
      names = "--cap",
      paramLabel = "S",
      defaultValue = "20",
      description =
          "Seconds after which warm-up and slow engines stop early; their row says so, 0..3600"
              + " (${DEFAULT-VALUE}).")
  private double capSeconds;

  @Option(
      names = "--quick",
      description = "A first look: a quarter of warm-up, cap and timed steps.")
  private boolean quick;

  @Option(
      names = "--json",
      paramLabel = "FILE",
      arity = "0..1",
      fallbackValue = STANDARD_OUTPUT,
      description =
          "Prints the rows to standard output, a JSON object per line, and the tables to standard"
              + " error; with FILE writes them there.")
  private Path json;

  @Option(names = "--markdown", paramLabel = "FILE", description = "Writes the tables in Markdown.")
  private Path markdown;

  @Option(
      names = {"-h", "--help"},
      usageHelp = true,
      description = "Shows this text.")
  @SuppressWarnings("unused") // picocli shows the help
  private boolean help;

  private final List<BenchRow> rows = new ArrayList<>();
  private final List<BenchProcess> processes = new CopyOnWriteArrayList<>();

  /** Creates the command, for picocli. */
  public BenchCommand() {}

  /**
   * Runs the command alone, as {@code ./gradlew bench} does.
   *
   * @param args see {@code --help}
   */
  public static void main(String[] args) {
    System.exit(BadFlag.explainedBy(new CommandLine(new BenchCommand())).execute(args));
  }

  @Override
  public Integer call() throws InterruptedException {
    requireRange("--warm-up", warmUpSeconds);
    requireRange("--cap", capSeconds);
    List<BenchJob> jobs = jobs();
    BenchJob.Choice wanted = new BenchJob.Choice(kinds(), threadCounts(), everyPeer());
    PrintWriter out = spec.commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    Runtime.getRuntime().addShutdownHook(new Thread(this::endProcesses, "bench-stop"));
    try {
      write(); // so that a file that can't be written ends the command before the work
      for (int i = 0; i < jobs.size(); i++) {
        BenchJob job = jobs.get(i);
        String progress = "[" + (i + 1) + "/" + jobs.size() + "] " + job.name();
        List<BenchRow> ofJob = measure(job, wanted, progress, err);
        compare(job, ofJob);
        rows.addAll(ofJob);
        write();
        if (jsonToOutput()) {
          ofJob.forEach(row -> out.println(row.toJson()));
          out.flush();
        }
      }
    } catch (IOException e) {
      err.println("bench: " + e);
      err.flush();
      return CommandLine.ExitCode.SOFTWARE;
    }
    PrintWriter tables = jsonToOutput() ? err : out;
    tables.print(BenchTable.plain(rows));
    tables.flush();
    return CommandLine.ExitCode.OK;
  }

  private boolean jsonToOutput() {
    return json != null && json.toString().equals(STANDARD_OUTPUT);
  }

  /**
   * Measures all entrants of a job in turns: each does its first slice, then each its second one.
   *
   * @return the row of each entrant
   */
  private List<BenchRow> measure(
      BenchJob job, BenchJob.Choice wanted, String progress, PrintWriter err)
      throws IOException, InterruptedException {
    try {
      for (Entrant entrant : job.entrants(wanted)) {
        processes.add(process(job, entrant));
      }
      List<BenchProcess> busy = new ArrayList<>(processes);
      for (int round = 0; !busy.isEmpty(); round++) {
        for (BenchProcess process : List.copyOf(busy)) {
          if (round == 0) {
            tell(err, progress + ", " + process.entrant() + ": warm-up");
          }
          if (!process.turn()) {
            busy.remove(process);
            tell(err, progress + ", " + process.entrant() + ": " + outcome(process.row()));
          }
        }
      }
      return new ArrayList<>(processes.stream().map(BenchProcess::row).toList());
    } finally {
      endProcesses();
    }
  }

  private static void tell(PrintWriter err, String line) {
    err.println(line);
    err.flush();
  }

  private static String outcome(BenchRow row) {
    String time = row.isMeasured() ? String.format(Locale.ROOT, "%.3f ms ", row.medianMs()) : "";
    return (time + row.fault()).strip();
  }

  /** Adds the ratios to Carom's rows of a job, and finds entrants that should have agreed. */
  private static void compare(BenchJob job, List<BenchRow> ofJob) {
    BenchRow first = ofJob.get(0);
    for (int i = 0; i < ofJob.size(); i++) {
      BenchRow row = ofJob.get(i);
      if (row.counts()
          && first.counts()
          && job.mustAgree(row.entrant())
          && !row.hash().equals(first.hash())) {
        row = row.withFault("ends differently from " + first.entrant());
      }
      ofJob.set(i, row.entrant().isCarom() ? row.withRatios(ratios(row, ofJob)) : row);
    }
  }

  private static Map<String, Double> ratios(BenchRow row, List<BenchRow> ofJob) {
    Map<String, Double> ratios = new LinkedHashMap<>();
    for (BenchRow other : ofJob) {
      if (row.isMeasured() && other.isMeasured() && !other.entrant().isCarom()) {
        ratios.put(other.entrant().engine(), other.medianMs() / row.medianMs());
      }
    }
    return ratios;
  }

  private BenchProcess process(BenchJob job, Entrant entrant) throws IOException {
    Path program = external.get(entrant.engine());
    if (program == null) {
      return new BenchProcess(job.name(), entrant, command(job, entrant), null);
    }
    List<String> command = new ArrayList<>(List.of(program.toString(), job.name()));
    SceneFile file = null;
    if (job instanceof SceneJob ofScene) {
      BenchScene how = ofScene.scene();
      file = SceneFile.of(quick ? how.quick() : how);
      command.addAll(List.of(file.scene().toString(), file.poses().toString()));
    }
    return new BenchProcess(job.name(), entrant, command, file);
  }

  private List<String> command(BenchJob job, Entrant entrant) {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-Xms256m", "-Xmx3g", "-XX:+UseSerialGC"));
    if (entrant.kernels().equals(VECTOR)) {
      command.addAll(List.of("--add-modules", VECTOR_MODULE));
    }
    command.addAll(List.of("-cp", Peers.classPath(), BenchChild.class.getName()));
    command.addAll(List.of(entrant.engine(), entrant.kernels()));
    command.addAll(List.of(Integer.toString(entrant.threads()), job.name()));
    command.add(Double.toString(quick ? warmUpSeconds / 4 : warmUpSeconds));
    command.add(Double.toString(quick ? capSeconds / 4 : capSeconds));
    command.add(Boolean.toString(quick));
    return command;
  }

  private void endProcesses() {
    processes.forEach(BenchProcess::close);
    processes.clear();
  }

  private void write() throws IOException {
    if (json != null && !jsonToOutput()) {
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
      return scenes == null ? Jobs.all() : Jobs.of(scenes);
    } catch (IllegalArgumentException e) {
      throw bad("--scenes: " + e.getMessage());
    }
  }

  private List<String> everyPeer() {
    List<String> all = new ArrayList<>(others());
    for (Map.Entry<String, Path> each : external.entrySet()) {
      if (all.contains(each.getKey()) || each.getKey().equals(Entrant.CAROM)) {
        throw bad("--external: name=" + each.getKey() + " is taken; choose another one");
      }
      if (!Files.isExecutable(each.getValue())) {
        throw bad("--external: program=" + each.getValue() + " can't be run");
      }
      all.add(each.getKey());
    }
    return all;
  }

  private List<String> others() {
    List<String> known = Peers.names();
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
                    ? ": there are no other engines here; use ./gradlew bench"
                    : ": known are " + String.join(", ", known) + ", or none"));
      }
    }
    return peers;
  }

  private List<Integer> threadCounts() {
    if (threads == null) {
      return Runtime.getRuntime().availableProcessors() > 1 ? List.of(1, 2) : List.of(1);
    }
    for (int count : threads) {
      if (count < 1 || count > MAX_THREADS) {
        throw bad("--threads=" + count + " is outside 1.." + MAX_THREADS);
      }
    }
    return threads.stream().distinct().sorted().toList();
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

  private BadFlag bad(String message) {
    return new BadFlag(spec.commandLine(), message);
  }
}
