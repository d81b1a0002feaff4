package carom.server.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.replay.Block;
import carom.suite.Needs;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

@Needs("waits")
class RotationLimitTest {
  @TempDir private Path folder;

  @ParameterizedTest
  @CsvSource({
    "0,0,0",
    "1,60,0",
    "1440,86400,0",
    "1M,0,1048576",
    "256M,0,268435456",
    "2G,0,2147483648"
  })
  void minutesAndSizesAreRead(String text, int seconds, long bytes) {
    assertEquals(new RotationLimit(seconds, bytes), RotationLimit.parse(text));
    assertEquals(seconds > 0 || bytes > 0, RotationLimit.parse(text).rotates());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "-1", "1441", "0M", "2049M", "3G", "1.5G", "256m", "9999999999"})
  void allElseIsRefusedWithWhatIsPossible(String text) {
    IllegalArgumentException e =
        assertThrows(IllegalArgumentException.class, () -> RotationLimit.parse(text));
    assertTrue(e.getMessage().startsWith(text + " is neither minutes, 1..1440"), e.getMessage());
  }

  @Test
  void aFileIsFullOnceTheDiskHasTheSizeButNotInItsFirstSeconds() throws Exception {
    RotatingRecording files =
        new RotatingRecording(() -> folder.resolve("a.carom"), new RotationLimit(0, 5_000), 0);
    assertFalse(files.isFull(100), "there is none yet");
    RecordingFile file = files.next();
    assertFalse(files.isFull(100));
    write(file);
    assertFalse(files.isFull(9.9));
    assertTrue(files.isFull(10));
    files.close();
  }

  /** Bytes that don't compress. */
  private static void write(RecordingFile file) throws IOException, InterruptedException {
    byte[] bytes = new byte[6_000];
    new Random(1).nextBytes(bytes);
    assertTrue(file.take(Block.TICKS, bytes, bytes.length));
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(20);
    while (file.writtenBytes() < 5_000 && System.nanoTime() < end) {
      Thread.sleep(1);
    }
  }
}
