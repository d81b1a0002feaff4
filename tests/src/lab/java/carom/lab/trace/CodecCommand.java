package carom.lab.trace;

import carom.options.BadFlag;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/**
 * Runs {@code carom-bots codec}, which measures the size of recorded motion coded by {@link
 * TraceCodec}. The last line of standard output is one JSON object; see {@link TraceReport}.
 */
@Command(
    name = "codec",
    mixinStandardHelpOptions = true,
    sortOptions = false,
    description = {
      "Measures the snapshot codec on a recording of moving bodies.",
      "The file: little-endian int32 bodies, ticks, hz; then float32 x, y, angle, vx, vy, omega for"
          + " each tick and body."
    },
    footer = "Exit code 0 only if the decoder gave back exactly what was encoded.")
public final class CodecCommand implements Callable<Integer> {

  private static final int MAX_SECONDS = 600;

  @Option(
      names = "--trace",
      paramLabel = "FILE",
      required = true,
      description = "The recording; with --record, where it is written.")
  private Path trace;

  @Option(
      names = "--rate",
      paramLabel = "HZ",
      description = "Snapshots per second, at most the recording's (the recording's).")
  private Integer rate;

  @Option(
      names = "--lag",
      paramLabel = "SNAPSHOTS",
      description = "How many snapshots the acknowledged baseline is old, 1..64 (100 ms of them).")
  private Integer lag;

  @Option(names = "--full", description = "Velocities too, not only poses.")
  private boolean full;

  @Option(
      names = "--record",
      paramLabel = "SCENE",
      description = "First record this scene of the library into the file.")
  private String scene;

  @Option(
      names = "--seconds",
      paramLabel = "S",
      description = "How long to record, seconds, 1..600 (${DEFAULT-VALUE}).",
      defaultValue = "20")
  private int seconds = 20;

  @CommandLine.Spec private CommandLine.Model.CommandSpec spec;

  /** Creates the command, for picocli. */
  public CodecCommand() {}

  @Override
  public Integer call() {
    try {
      if (scene != null) {
        record();
      }
      Trace read = Trace.read(trace);
      int snapshotRate = rate == null ? read.hz() : rate;
      int snapshotLag = lag == null ? Math.max(1, (snapshotRate + 5) / 10) : lag;
      TraceReport report =
          TraceReport.of(read, snapshotRate, snapshotLag, full ? TraceCodec.FULL : TraceCodec.POSE);
      System.out.println(report.toJson());
      return report.exact() ? 0 : 1;
    } catch (NoSuchFileException e) {
      throw problem("--trace=" + trace + ": no such file or directory");
    } catch (IOException | UncheckedIOException e) {
      throw problem("--trace=" + trace + ": " + e.getMessage());
    } catch (IllegalArgumentException e) {
      throw problem(e.getMessage());
    }
  }

  private BadFlag problem(String what) {
    return new BadFlag(spec.commandLine(), what);
  }

  /** Writes the dynamic and kinematic bodies that the scene begins with. */
  private void record() throws IOException {
    if (seconds < 1 || seconds > MAX_SECONDS) {
      throw problem("--seconds=" + seconds + " is outside 1.." + MAX_SECONDS);
    }
    SceneTrace.of(scene, seconds).write(trace);
  }
}
