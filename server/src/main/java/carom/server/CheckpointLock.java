package carom.server;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * The right to use a folder of checkpoints, which one process has at a time. It ends with the
 * process, however that ends.
 */
final class CheckpointLock implements AutoCloseable {
  private final FileChannel file;

  private CheckpointLock(FileChannel file) {
    this.file = file;
  }

  /**
   * Takes the right to a folder, and creates the folder if it isn't there.
   *
   * @throws IOException if another server has it, or the folder can't be used; the message says so
   */
  public static CheckpointLock of(Path folder) throws IOException {
    Files.createDirectories(folder);
    FileChannel file =
        FileChannel.open(
            folder.resolve("lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
    FileLock lock = null;
    try {
      lock = file.tryLock();
    } catch (OverlappingFileLockException e) {
      lock = null; // another server of this process
    } finally {
      if (lock == null) {
        file.close();
      }
    }
    if (lock == null) {
      throw new IOException(
          "another server uses folder=" + folder + "; give each server a data folder of its own");
    }
    return new CheckpointLock(file);
  }

  @Override
  public void close() {
    try {
      file.close();
    } catch (IOException e) {
      return; // the process's end releases it
    }
  }
}
