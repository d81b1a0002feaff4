package carom.physics;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/**
 * Computes the golden scenes and the golden recordings on an AArch64 JDK that QEMU emulates, and
 * compares the hashes with those of this machine. A difference makes the exit code 1.
 */
@Command(
    name = "aarch64",
    mixinStandardHelpOptions = true,
    description = "Compares golden hashes of an emulated AArch64 JDK with this machine's.")
public final class Aarch64Main implements Callable<Integer> {
  private static final String VECTORS = "--add-modules=jdk.incubator.vector";

  /** Processors with vectors of 128 and of 256 bits. The engine's contact kernels need 256. */
  private static final String NEON = "cortex-a72";

  private static final String SVE = "max,sve256=on";

  /** A way of running the JVM: "small" makes the scenes short enough for the interpreter. */
  private record Variant(String cpu, String option, boolean small) {}

  private static final List<Variant> VARIANTS =
      List.of(
          new Variant(NEON, "-Xint", true),
          new Variant(NEON, "-XX:TieredStopAtLevel=1", false),
          new Variant(NEON, "-XX:+TieredCompilation", false),
          new Variant(NEON, VECTORS, false),
          new Variant(SVE, VECTORS, false));

  @Option(
      names = "--folder",
      paramLabel = "FOLDER",
      required = true,
      description = "keeps QEMU and the JDK from run to run")
  private Path folder;

  @Option(
      names = "--minutes",
      paramLabel = "N",
      description = "longest time for each program, default ${DEFAULT-VALUE}")
  private int minutes = 20;

  @Option(
      names = "--script",
      paramLabel = "FILE",
      required = true,
      description = "gradle/aarch64.sh")
  private Path script;

  @Option(
      names = "--recordings",
      paramLabel = "FOLDER",
      required = true,
      description = "recordings to compute again")
  private Path recordings;

  private int wrong;

  private Aarch64Main() {}

  /** Runs the command, see {@code --help}. */
  public static void main(String[] args) {
    System.exit(new CommandLine(new Aarch64Main()).execute(args));
  }

  @Override
  public Integer call() throws IOException, InterruptedException {
    say("java", "-", "", run(NEON, List.of("-Xint", "-version")), true);
    for (Variant v : VARIANTS) {
      compareScenes(v);
    }
    try (Stream<Path> files = Files.list(recordings)) {
      for (Path file : files.sorted().toList()) {
        List<String> replay =
            List.of("-cp", classPath(), "carom.server.CaromMain", "replay", file.toString());
        Result result = run(NEON, replay);
        boolean same = result.status == 0 && result.out.contains("OK: ");
        say("recording " + file.getFileName(), NEON, "", result, same);
      }
    }
    System.out.println(wrong == 0 ? "OK: all are the same" : wrong + " differ");
    return wrong == 0 ? 0 : 1;
  }

  private void compareScenes(Variant v) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(v.option, "-cp", classPath()));
    command.add(GoldenScenes.class.getName());
    if (v.small) {
      command.add("small");
    }
    Result result = run(v.cpu, command);
    Map<String, String> expected = byName(GoldenScenes.results(v.small));
    Map<String, String> actual = byName(result.out);
    int same = 0;
    for (var scene : expected.entrySet()) {
      String got = actual.get(scene.getKey());
      if (scene.getValue().equals(got)) {
        same++;
      } else {
        System.out.printf("  %s: here %s, there %s%n", scene.getKey(), scene.getValue(), got);
      }
    }
    String what = same + " of " + expected.size() + (v.small ? " short" : "") + " scenes";
    say(what, v.cpu, v.option, result, same == expected.size() && result.status == 0);
  }

  private static Map<String, String> byName(String lines) {
    Map<String, String> map = new TreeMap<>();
    lines.lines().forEach(line -> map.put(line.replaceAll(" .*", ""), line));
    return map;
  }

  private void say(String what, String cpu, String option, Result result, boolean right) {
    System.out.printf(
        Locale.ROOT,
        "%-28s %-14s %-36s %4d s  %s%n",
        what,
        cpu,
        option,
        TimeUnit.NANOSECONDS.toSeconds(result.nanos),
        right ? "same" : "DIFFERENT, status " + result.status + ": " + result.err);
    wrong += right ? 0 : 1;
  }

  private record Result(int status, String out, String err, long nanos) {}

  private Result run(String cpu, List<String> arguments) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(script.toString(), folder.toString(), cpu));
    command.addAll(List.of("-Xmx256m", "-XX:+UseSerialGC"));
    command.addAll(arguments);
    File out = File.createTempFile("aarch64", ".out");
    File err = File.createTempFile("aarch64", ".err");
    try {
      long start = System.nanoTime();
      Process p = new ProcessBuilder(command).redirectOutput(out).redirectError(err).start();
      boolean ended = p.waitFor(minutes, TimeUnit.MINUTES);
      if (!ended) {
        p.destroyForcibly().waitFor();
      }
      return new Result(
          ended ? p.exitValue() : -1, text(out), text(err), System.nanoTime() - start);
    } finally {
      Files.delete(out.toPath());
      Files.delete(err.toPath());
    }
  }

  private static String text(File file) throws IOException {
    return Files.readString(file.toPath(), StandardCharsets.UTF_8);
  }

  private static String classPath() {
    return System.getProperty("java.class.path");
  }
}
