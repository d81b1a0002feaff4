package carom.server;

import carom.game.GamesOption;
import carom.net.protocol.Protocol;
import carom.replay.Divergence;
import carom.replay.RecordingException;
import carom.replay.RecordingHeader;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.text.FileErrors;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Runs {@code carom replay FILE}, which computes a recorded game again and compares every tick. */
@Command(
    name = "replay",
    sortOptions = false,
    usageHelpAutoWidth = true,
    mixinStandardHelpOptions = true,
    description = {
      "Computes a recorded game again, as fast as it can, and compares the state of every tick.",
      ""
    },
    footer = {
      "",
      "Exit codes: 0 every tick is equal, 1 it diverged, 2 bad flag, or a file that can't be"
          + " played."
    })
public final class ReplayCommand implements Callable<Integer> {
  private static final int DIVERGED = 1;
  private static final int BAD_FILE = 2;

  @Spec private CommandSpec spec;

  @Mixin
  @SuppressWarnings("unused") // picocli gives it the flag
  private GamesOption games;

  @Parameters(paramLabel = "FILE", description = "What carom-server --record has written.")
  private Path file;

  @Option(
      names = "--any-physics",
      description = "Play even what another build's arithmetic has recorded.")
  private boolean anyPhysics;

  @Option(
      names = "--from",
      paramLabel = "TICK",
      defaultValue = "0",
      description =
          "Begin at the last whole state that the file has at or before this tick; there is one a"
              + " minute (${DEFAULT-VALUE}).")
  private int from;

  /** Creates a command that picocli has yet to fill in. */
  public ReplayCommand() {}

  @Override
  public Integer call() {
    PrintWriter out = spec.commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    try (RecordingReader reader = RecordingReader.open(file)) {
      RecordingHeader header = reader.header();
      out.println(header);
      out.flush();
      if (!anyPhysics) {
        Replay.requirePhysics(header, Protocol.physicsDigest());
      }
      Replay replay = new Replay(reader);
      if (from > 0) {
        replay.goToStateBefore(from);
      }
      return play(reader, replay, out, err);
    } catch (IOException e) {
      String message =
          e instanceof RecordingException ? e.getMessage() : file + ": " + FileErrors.reason(e);
      err.println("carom replay: " + message);
      err.flush();
      return BAD_FILE;
    }
  }

  private static int play(RecordingReader reader, Replay replay, PrintWriter out, PrintWriter err)
      throws IOException {
    long beginNs = System.nanoTime();
    Replay.Progress progress;
    try {
      do {
        progress = replay.step();
      } while (progress == Replay.Progress.TICK && !isOver(replay));
    } catch (RecordingException e) {
      out.println(verdict(replay, System.nanoTime() - beginNs) + "; then the file is unusable");
      out.flush();
      throw e;
    }
    out.println(verdict(replay, System.nanoTime() - beginNs));
    if (progress == Replay.Progress.END && reader.isCut()) {
      out.println("The recording was cut here: " + reader.reason());
    } else if (progress == Replay.Progress.END) {
      out.println("End of the recording: " + reader.reason());
    } else if (progress == Replay.Progress.WAIT) {
      out.printf(
          Locale.ROOT,
          "The file ends here, %d bytes into a block: it is torn, or still being written.%n",
          reader.tornBytes());
    }
    out.flush();
    err.flush();
    return replay.divergence() == null ? 0 : DIVERGED;
  }

  /**
   * Returns whether the replay ends at a divergence: the recording of this game has no later whole
   * state to go on from.
   */
  private static boolean isOver(Replay replay) {
    return replay.isDecided() && replay.simulation().game().keepsMore();
  }

  private static String verdict(Replay replay, long tookNs) {
    List<Divergence> found = replay.divergences();
    if (!found.isEmpty()) {
      StringBuilder text = new StringBuilder();
      found.forEach(divergence -> text.append(divergence).append(System.lineSeparator()));
      return text.append("DIVERGED: ")
          .append(found.size() == 1 ? "once" : found.size() + " times")
          .append("; ")
          .append(replay.equalTicks())
          .append(" ticks equal up to tick ")
          .append(replay.simulation().tick())
          .toString();
    }
    int ticks = replay.simulation().tick() - replay.firstTick();
    double seconds = Math.max(1e-9, tookNs / 1e9);
    return String.format(
        Locale.ROOT,
        "OK: %d ticks equal%s in %.2f s, %.0f ticks/s, %.0f times as fast as played, final hash"
            + " %016x",
        ticks,
        replay.firstTick() == 0 ? "" : " from tick " + replay.firstTick() + " on",
        seconds,
        ticks / seconds,
        ticks / seconds / replay.simulation().tickRate(),
        replay.simulation().stateHash());
  }
}
