package carom.server.web;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: the page lists what can be downloaded, each recording once. */
final class DownloadsTest {
  @TempDir private Path data;

  @Test
  void aFolderThatIsNamedTwiceIsListedOnce() throws Exception {
    Path recordings = Files.createDirectories(data.resolve("recordings"));
    Files.writeString(recordings.resolve("evening.carom"), "game");
    Files.writeString(recordings.resolve("notes.txt"), "no game");
    Path again = data.resolve("x").resolve("..").resolve("recordings");
    List<Downloads.Recording> list = new Downloads(List.of(recordings, again), () -> 0).list();
    assertEquals(List.of("evening.carom"), list.stream().map(Downloads.Recording::name).toList());
  }
}
