package carom.server;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * The right to use a folder, which one server has at a time: two would write over each other's
 * files. It ends with the process, however that ends.
 */
final class FolderLock implements AutoCloseable {
  /** Another server has the right. */
  static final class TakenException extends IOException {
    private static final long serialVersionUID = 1;

    private TakenException(String message) {
      super(message);
    }
  }

  private final FileChannel file;

  private FolderLock(FileChannel file) {
    this.file = file;
  }

  /**
   * Takes the right to a folder, and creates the folder if it isn't there.
   *
   * @param setting names the folder in messages
   * @throws TakenException if another server has it
   * @throws IOException if the folder can't be used; the message says why
   */
  public static FolderLock of(Path folder, String setting) throws IOException {
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
      throw new TakenException(
          "another server uses "
              + setting
              + "="
              + folder
              + "; give each server a folder of its own with --data");
    }
    return new FolderLock(file);
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
