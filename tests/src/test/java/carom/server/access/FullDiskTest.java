package carom.server.access;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.net.seal.ServerKey;
import carom.server.recording.RecordingFile;
import carom.suite.Needs;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a disk that is full at the first start leaves no file that the next start reads as broken.
 * Method: a process that may create files, but not write a byte to them.
 */
@Needs("processes")
@Timeout(60)
final class FullDiskTest {
  @TempDir private Path folder;

  /** Tries to make each kind of file. */
  public static void main(String[] args) {
    Path folder = Path.of(args[0]);
    attempt(() -> ServerKey.load(folder.resolve("server.key")));
    attempt(() -> Secret.of(folder.resolve("admin.token")));
    attempt(() -> RecordingFile.create(folder.resolve("game.carom")));
    System.exit(0);
  }

  /** Something that makes a file. */
  private interface Attempt {
    void run() throws IOException;
  }

  private static void attempt(Attempt attempt) {
    try {
      attempt.run();
      System.out.println("written");
    } catch (IOException e) {
      System.out.println(e.getMessage());
    }
  }

  @Test
  void nothingEmptyStaysAndTheMessageHasNoClass() throws Exception {
    assumeTrue(File.separatorChar == '/', "Windows has no ulimit");
    Process process =
        new ProcessBuilder(
                "sh",
                "-c",
                "ulimit -f 0 && exec \"$@\"",
                "sh",
                System.getProperty("java.home") + "/bin/java",
                "-XX:-UsePerfData",
                "-cp",
                System.getProperty("java.class.path"),
                FullDiskTest.class.getName(),
                folder.toString())
            .redirectErrorStream(true)
            .start();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), text);
    assertEquals(
        List.of(
            folder
                + "/server.key can't be written (File too large); free the disk or make its folder"
                + " writable",
            folder + "/admin.token can't be written: File too large",
            "file=" + folder + "/game.carom can't be created: File too large"),
        text.lines().toList());
    try (Stream<Path> left = Files.list(folder)) {
      assertEquals(List.of(), left.toList());
    }
    ServerKey.load(folder.resolve("server.key"));
    assertTrue(Files.size(folder.resolve("server.key")) > 40, "the next start makes it");
  }
}
