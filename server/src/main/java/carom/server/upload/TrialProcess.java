package carom.server.upload;

import carom.game.GameJars;
import carom.text.Texts;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Runs {@link LevelTrial} in a process with a bounded heap, one processor and a deadline. A thread
 * would share the heap with the matches, and one that never comes back can't be ended.
 */
final class TrialProcess implements Uploads.Judge {
  /** Heap of the process, MiB. */
  private static final int HEAP_MIB = 192;

  /** Longest time of a process, however little of the processor it gets. */
  private static final long MOST_MS = 120_000;

  private static final long LOOK_MS = 50;
  private static final int MAX_VERDICT = 4_096;
  private static final int MAX_LINE = 160;

  /**
   * The verdict of a trial.
   *
   * @param problems what is wrong, one for each line; empty if the level is good
   */
  record Verdict(String name, String game, List<String> problems) {
    static Verdict bad(String problem) {
      return new Verdict("", "", List.of(problem));
    }
  }

  private final Duration budget;

  /**
   * Creates one whose processes are ended.
   *
   * @param budget time of the processor that one may take; matches may leave it little of a second
   */
  TrialProcess(Duration budget) {
    this.budget = budget;
  }

  /** Returns the command of the process. */
  private static List<String> command() {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx" + HEAP_MIB + "m",
                "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1",
                "-XX:ActiveProcessorCount=1",
                "-XX:+ExitOnOutOfMemoryError",
                "-Djava.awt.headless=true",
                "-cp",
                System.getProperty("java.class.path"),
                LevelTrial.class.getName()));
    Path games = GameJars.folder();
    if (games != null) {
      command.add(games.toString());
    }
    return command;
  }

  @Override
  public Verdict judge(Path level, Path verdict) throws IOException, InterruptedException {
    Process process =
        new ProcessBuilder(command())
            .redirectInput(level.toFile())
            .redirectOutput(verdict.toFile())
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    try {
      if (!ends(process)) {
        return Verdict.bad(
            "the check takes longer than "
                + budget.toSeconds()
                + " s of a processor; use fewer bodies that touch");
      }
    } finally {
      process.destroyForcibly();
    }
    List<String> lines = lines(verdict);
    String first = lines.isEmpty() ? "" : lines.get(0);
    if (process.exitValue() == 0 && first.equals(LevelTrial.GOOD) && lines.size() == 3) {
      return new Verdict(lines.get(2), lines.get(1), List.of());
    }
    if (process.exitValue() == 0 && first.equals(LevelTrial.BAD) && lines.size() > 1) {
      return new Verdict("", "", lines.subList(1, lines.size()));
    }
    return Verdict.bad(
        "the check fails with exit="
            + process.exitValue()
            + "; the level may need more than "
            + HEAP_MIB
            + " MiB");
  }

  /** Waits for a process, and returns whether it ends within its time. */
  private boolean ends(Process process) throws InterruptedException {
    for (long waited = 0; waited < MOST_MS; waited += LOOK_MS) {
      if (process.waitFor(LOOK_MS, TimeUnit.MILLISECONDS)) {
        return true;
      }
      Duration used = process.info().totalCpuDuration().orElse(Duration.ZERO);
      if (used.compareTo(budget) > 0) {
        return false;
      }
    }
    return false;
  }

  private static List<String> lines(Path verdict) throws IOException {
    try (InputStream in = Files.newInputStream(verdict)) {
      String text = new String(in.readNBytes(MAX_VERDICT), StandardCharsets.UTF_8);
      return text.lines()
          .map(Texts::clean)
          .map(line -> line.length() > MAX_LINE ? line.substring(0, MAX_LINE) + " ..." : line)
          .toList();
    }
  }
}
