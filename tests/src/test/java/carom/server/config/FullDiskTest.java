package carom.server.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.server.LogFiles;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a full disk costs what is written now, and nothing that was written before. Method: links
 * to {@code /dev/full}, a device of Linux that is always full.
 */
class FullDiskTest {
  private static final Path FULL = Path.of("/dev/full");

  @TempDir private Path folder;

  @BeforeEach
  void onlyWhereThereIsAFullDevice() {
    assumeTrue(Files.exists(FULL), "no " + FULL);
  }

  @Test
  void aFileThatCanNotBeReplacedStaysAndNothingHalfWrittenIsLeft() throws IOException {
    Path file = Files.writeString(folder.resolve("cup.carom-save"), "old");
    Path fresh = Files.createSymbolicLink(folder.resolve("cup.carom-save.new"), FULL);
    IOException e =
        assertThrows(IOException.class, () -> DataFolder.replace(file, new byte[100_000]));
    assertTrue(e.getMessage().contains("No space left"), e.getMessage());
    assertEquals("old", Files.readString(file));
    assertFalse(Files.exists(fresh, LinkOption.NOFOLLOW_LINKS));
    DataFolder.replace(file, new byte[10]);
    assertEquals(10, Files.size(file));
  }

  @Test
  void theLogGoesOnOnStandardErrorAndNothingThrows() throws IOException {
    Path logs = Files.createDirectory(folder.resolve("logs"));
    Files.createSymbolicLink(logs.resolve("carom.log"), FULL);
    LoggerContext logging = new LoggerContext();
    ListAppender<ILoggingEvent> other = new ListAppender<>();
    other.start();
    Logger root = logging.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME);
    root.addAppender(other);
    LogFiles.begin(logging, logs, 2);
    for (int i = 0; i < 3_000; i++) {
      root.info("line {}", i);
    }
    logging.stop();
    assertEquals(3_000, other.list.size());
  }
}
