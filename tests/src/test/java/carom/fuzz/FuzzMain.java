package carom.fuzz;

import carom.testkit.Folders;
import carom.text.Suggestion;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/**
 * Drives targets by Jazzer, one process for each, and says what came out. A finding stays as a file
 * and makes the exit code 1.
 */
@Command(
    name = "fuzz",
    mixinStandardHelpOptions = true,
    description = "Looks for inputs that break what reads bytes of others.")
public final class FuzzMain implements Callable<Integer> {
  /** Largest corpus that is kept, in bytes before compression. */
  private static final int MOST_KEPT = 700_000;

  private static final int FINDING = 77; // the exit code of Jazzer
  private static final Pattern PROGRESS =
      Pattern.compile("^#(\\d+)\\s+\\w+\\s+cov: (\\d+) .*corp: (\\d+)/");

  @Option(
      names = "--target",
      paramLabel = "NAME",
      description = "one of message, input, ...; default: all. May be given more than once")
  private List<String> targets = new ArrayList<>();

  @Option(
      names = "--inputs",
      paramLabel = "N",
      description = "inputs for each target, default ${DEFAULT-VALUE}")
  private long inputs = 100_000;

  @Option(
      names = "--seconds",
      paramLabel = "N",
      description = "longest time for each target, default ${DEFAULT-VALUE}")
  private int seconds = 600;

  @Option(names = "--seed", paramLabel = "N", description = "seed of Jazzer, default: any")
  private long seed;

  @Option(
      names = "--keep",
      paramLabel = "FOLDER",
      description = "writes the smallest corpus of the same coverage to FOLDER/NAME.zip")
  private Path keep;

  @Option(
      names = "--work",
      paramLabel = "FOLDER",
      description = "corpora, logs and findings of this run, default ${DEFAULT-VALUE}")
  private Path work = Path.of("build", "fuzz");

  /** What a run of one target came to. */
  private record Outcome(long inputs, long coverage, long corpus, double seconds, int exit) {}

  private FuzzMain() {}

  /** Runs the command. */
  public static void main(String[] args) {
    System.exit(new CommandLine(new FuzzMain()).execute(args));
  }

  @Override
  public Integer call() throws Exception {
    for (String target : targets) {
      if (!FuzzTargets.names().contains(target)) {
        System.err.println(
            "unknown target=%s; targets are %s%s"
                .formatted(
                    target,
                    String.join(", ", FuzzTargets.names()),
                    Suggestion.didYouMean(target, FuzzTargets.names())));
        return CommandLine.ExitCode.USAGE;
      }
    }
    boolean found = false;
    System.out.println("target          inputs  inputs/s  coverage  corpus");
    for (String target : targets.isEmpty() ? FuzzTargets.names() : targets) {
      Outcome outcome = fuzz(target);
      System.out.printf(
          "%-12s %9d %9.0f %9d %7d%n",
          target,
          outcome.inputs,
          outcome.inputs / Math.max(1e-3, outcome.seconds),
          outcome.coverage,
          outcome.corpus);
      if (outcome.exit == FINDING) {
        found = true;
        System.out.println("  finding, see " + folder(target).resolve("log.txt"));
      } else if (outcome.exit != 0) {
        System.out.println(
            "  ended with exit=" + outcome.exit + ", see " + folder(target).resolve("log.txt"));
        found = true;
      } else if (keep != null) {
        keep(target);
      }
    }
    return found ? 1 : 0;
  }

  private Path folder(String target) {
    return work.resolve(target).toAbsolutePath();
  }

  private Outcome fuzz(String target) throws Exception {
    Path folder = folder(target);
    Folders.delete(folder.resolve("corpus"));
    Path corpus = Files.createDirectories(folder.resolve("corpus"));
    int number = 0;
    for (byte[] input : FuzzTargets.inputs(target)) {
      Files.write(corpus.resolve("begin" + number++), input);
    }
    List<String> flags = new ArrayList<>();
    flags.add("-runs=" + inputs);
    flags.add("-max_total_time=" + seconds);
    flags.add("-max_len=20000");
    if (seed != 0) {
      flags.add("-seed=" + seed);
    }
    flags.add(corpus.toString());
    long start = System.nanoTime();
    int exit = jazzer(target, "log.txt", flags);
    double took = (System.nanoTime() - start) / 1e9;
    long done = 0;
    long coverage = 0;
    long kept = 0;
    for (String line : Files.readAllLines(folder.resolve("log.txt"))) {
      Matcher progress = PROGRESS.matcher(line);
      if (progress.find()) {
        done = Long.parseLong(progress.group(1));
        coverage = Long.parseLong(progress.group(2));
        kept = Long.parseLong(progress.group(3));
      }
    }
    return new Outcome(done, coverage, kept, took, exit);
  }

  private int jazzer(String target, String log, List<String> flags) throws Exception {
    Path folder = folder(target);
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx1g",
                "--add-modules",
                "jdk.incubator.vector",
                "-D" + FuzzEntry.TARGET + "=" + target,
                "-cp",
                System.getProperty("java.class.path"),
                "com.code_intelligence.jazzer.Jazzer",
                "--target_class=" + FuzzEntry.class.getName(),
                "--instrumentation_includes=carom.**",
                "--disabled_hooks=**"));
    command.addAll(flags);
    ProcessBuilder builder =
        new ProcessBuilder(command)
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectOutput(folder.resolve(log).toFile());
    // A target that asks its own server over a socket is no attack on other machines.
    builder.environment().put("JAZZER_SSRF_PERMISSIVE_UNTIL_CONFIGURED", "1");
    Process process = builder.start();
    if (!process.waitFor(seconds + 1_800L, TimeUnit.SECONDS)) {
      process.destroyForcibly();
      return -1;
    }
    return process.exitValue();
  }

  /** Writes the smallest corpus that covers the same, without what would make it too large. */
  private void keep(String target) throws Exception {
    Path folder = folder(target);
    Folders.delete(folder.resolve("smallest"));
    Path smallest = Files.createDirectories(folder.resolve("smallest"));
    int exit =
        jazzer(
            target,
            "merge.txt",
            List.of("-merge=1", smallest.toString(), folder.resolve("corpus").toString()));
    if (exit != 0) {
      throw new IOException("merging failed, see " + folder.resolve("merge.txt"));
    }
    Map<String, byte[]> inputs = new TreeMap<>();
    try (var files = Files.list(smallest)) {
      for (Path file : files.toList()) {
        inputs.put(file.getFileName().toString(), Files.readAllBytes(file));
      }
    }
    Files.createDirectories(keep);
    try (OutputStream out = Files.newOutputStream(keep.resolve(target + ".zip"));
        ZipOutputStream zip = new ZipOutputStream(out)) {
      int bytes = 0;
      for (Map.Entry<String, byte[]> input : inputs.entrySet()) {
        bytes += input.getValue().length;
        if (bytes > MOST_KEPT) {
          break;
        }
        ZipEntry entry = new ZipEntry(input.getKey());
        entry.setTime(0); // the same corpus is the same file
        zip.putNextEntry(entry);
        zip.write(input.getValue());
        zip.closeEntry();
      }
    }
  }
}
