package carom.server.recording;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.IntFunction;
import java.util.function.IntSupplier;

/**
 * The recordings of one room that spectators may watch: one for each match. The room's thread calls
 * {@link #next}; any thread the rest.
 */
public final class ShownRecordings implements RecordingFiles, AutoCloseable {
  private final IntFunction<Path> names;
  private final IntSupplier age;
  private final boolean temporary;
  private final List<DelayedRecording> recordings = new CopyOnWriteArrayList<>();
  private volatile int delayTicks;

  /**
   * Creates a list without a recording.
   *
   * @param names gives the path of a recording by its number, from 1 on
   * @param age returns how many ticks the room has run; called on the room's thread
   * @param temporary whether {@link #close} deletes the files
   */
  public ShownRecordings(IntFunction<Path> names, IntSupplier age, boolean temporary) {
    this.names = names;
    this.age = age;
    this.temporary = temporary;
  }

  @Override
  public DelayedRecording next() throws IOException {
    DelayedRecording recording =
        new DelayedRecording(new RecordingFile(names.apply(recordings.size() + 1)), age, temporary);
    if (delayTicks > 0) {
      recording.delay(delayTicks);
    }
    recordings.add(recording);
    return recording;
  }

  /** Shows the recordings with a delay. Call it before the first block is read. */
  public void delay(int newDelayTicks) {
    delayTicks = newDelayTicks;
    recordings.forEach(recording -> recording.delay(newDelayTicks));
  }

  /**
   * Returns the newest recording of which anything may be seen, or the first; null without any.
   *
   * @param now the room's age, in ticks
   */
  public DelayedRecording present(int now) {
    DelayedRecording present = null;
    for (DelayedRecording recording : recordings) {
      if (present == null || recording.shownBytes(now) > 0) {
        present = recording;
      }
    }
    return present;
  }

  /** Returns the paths of all recordings so far. */
  public List<Path> paths() {
    return recordings.stream().map(recording -> recording.file().path()).toList();
  }

  /** Closes all recordings. */
  @Override
  public void close() {
    recordings.forEach(DelayedRecording::close);
  }
}
