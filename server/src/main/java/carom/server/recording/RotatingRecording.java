package carom.server.recording;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A sequence of recording files for a room that runs for weeks. Each file can be played by itself.
 * The last few are kept and older ones deleted, but never a file that this object didn't create.
 *
 * <p>The room's thread calls {@link #next}, which creates and deletes files; that takes a disk
 * about a millisecond. Call {@link #close} after that thread has ended.
 */
public final class RotatingRecording implements RecordingFiles, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(RotatingRecording.class);

  private final Supplier<Path> names;
  private final RotationLimit limit;
  private final int keep;
  private final ArrayDeque<RecordingFile> files = new ArrayDeque<>();

  /**
   * Creates a sequence without a file.
   *
   * @param names gives another path at each call
   * @param limit length or size of each file
   * @param keep number of files to keep, the newest one included; 0 = all
   */
  public RotatingRecording(Supplier<Path> names, RotationLimit limit, int keep) {
    this.names = names;
    this.limit = limit;
    this.keep = keep;
  }

  /**
   * Creates the next file and deletes the oldest ones beyond the number to keep. The caller must
   * have ended the file before.
   *
   * @throws IOException when it can't be created
   */
  @Override
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
   * Returns whether the newest file has reached the limit.
   *
   * @param seconds length of the game in the newest file, s
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
