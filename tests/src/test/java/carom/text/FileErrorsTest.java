package carom.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: a message about a file names its reason and no class of Java. */
final class FileErrorsTest {
  @TempDir private Path folder;

  @Test
  void theReasonIsInWords() throws Exception {
    Path file = Files.writeString(folder.resolve("file"), "x");
    Path gone = folder.resolve("gone").resolve("new");
    assertEquals("there is no " + gone, of(() -> Files.writeString(gone, "x")));
    assertEquals(file + " is in the way", of(() -> Files.createDirectories(file)));
    assertEquals(
        "the user " + System.getProperty("user.name") + " may not",
        FileErrors.reason(new AccessDeniedException("file")));
    assertEquals(
        "the system says: Read-only file system",
        FileErrors.reason(new FileSystemException("file", null, "Read-only file system")));
    assertEquals("it is a folder", of(() -> Files.readString(folder)));
    assertEquals("it failed as EOFException", FileErrors.reason(new java.io.EOFException()));
  }

  @Test
  void aFullDiskIsNamed() {
    Path full = Path.of("/dev/full");
    assumeTrue(Files.exists(full), "only Linux has a device that is always full");
    assertEquals("No space left on device", of(() -> Files.writeString(full, "x")));
  }

  /** Something that fails. */
  private interface Attempt {
    void run() throws IOException;
  }

  private static String of(Attempt attempt) {
    return FileErrors.reason(assertThrows(IOException.class, attempt::run));
  }
}
