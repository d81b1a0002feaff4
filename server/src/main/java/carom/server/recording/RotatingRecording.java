package carom.server.recording;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One file after the other for a room that runs for weeks, each playable by itself, of which the
 * last few are kept. Files that were there before are never touched.
 *
 * <p>{@link #next} belongs to the room's thread; it creates and deletes a file, which takes a disk
 * about a millisecond. {@link #close} is for when that thread has ended.
 */
public final class RotatingRecording implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(RotatingRecording.class);

  private final Supplier<Path> names;
  private final RotationLimit limit;
  private final int keep;
  private final ArrayDeque<RecordingFile> files = new ArrayDeque<>();

  /**
   * Creates no file yet.
   *
   * @param names another name for each file
   * @param limit how long or large each gets
   * @param keep how many files to keep, the one being written included; 0 = all
   */
  public RotatingRecording(Supplier<Path> names, RotationLimit limit, int keep) {
    this.names = names;
    this.limit = limit;
    this.keep = keep;
  }

  /**
   * Begins the next file, and deletes the oldest one beyond the limit. Whoever wrote to the one
   * before has ended it.
   *
   * @throws IOException when it can't be created
   */
  public RecordingFile next() throws IOException {
    RecordingFile file = new RecordingFile(names.get());
    files.add(file);
    while (keep > 0 && files.size() > keep) {
      Path oldest = files.remove().path();
      try {
        Files.deleteIfExists(oldest);
      } catch (IOException e) {
        LOG.warn("recording {} is too old, but can't be deleted: {}", oldest, e.toString());
      }
    }
    return file;
  }

  /**
   * Whether another file is due.
   *
   * @param seconds of the game in the newest one
   */
  public boolean isFull(double seconds) {
    RecordingFile newest = files.peekLast();
    return newest != null && limit.isReached(seconds, newest.writtenBytes());
  }

  /** Closes the files that are still being written. */
  @Override
  public void close() {
    files.forEach(RecordingFile::close);
  }
}
