package carom.lab.soak;

import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.testkit.Folders;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * Computes the recordings of a server's life again on a thread of its own, while the next server
 * lives, and requires that they give the same hashes.
 */
final class Replays implements AutoCloseable {
  private final ExecutorService thread =
      Executors.newSingleThreadExecutor(task -> new Thread(task, "carom-soak-replays"));

  /** The ticks of the recordings that are computed, or null. */
  private Future<Long> running;

  private long ticks;

  /** Begins with the recordings of a folder, and deletes it then; those before must be equal. */
  void begin(Path folder) throws IOException {
    end();
    running = thread.submit(() -> replayAll(folder));
  }

  /**
   * Waits for the recordings that are computed.
   *
   * @throws AssertionError if one gives other hashes
   */
  void end() throws IOException {
    if (running == null) {
      return;
    }
    Future<Long> last = running;
    running = null;
    try {
      ticks += last.get();
    } catch (ExecutionException e) {
      if (e.getCause() instanceof AssertionError divergence) {
        throw divergence;
      }
      throw new IOException("a recording can't be computed again: " + e.getCause(), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }

  /** Returns the number of ticks that were computed again. */
  long ticks() {
    return ticks;
  }

  private static long replayAll(Path folder) throws IOException {
    long ticks = 0;
    try (Stream<Path> files = Files.list(folder)) {
      for (Path file : files.toList()) {
        ticks += replay(file);
      }
    }
    Folders.delete(folder);
    return ticks;
  }

  private static long replay(Path file) throws IOException {
    long ticks = 0;
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      while (replay.step() == Replay.Progress.TICK) {
        if (replay.divergence() != null) {
          throw new AssertionError(file + " replays to another state: " + replay.divergence());
        }
        ticks++;
      }
    }
    return ticks;
  }

  @Override
  public void close() {
    if (running != null) {
      running.cancel(false);
    }
    thread.shutdown();
    try {
      thread.awaitTermination(Long.MAX_VALUE, TimeUnit.NANOSECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
