package carom.server.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.Bot;
import carom.fixtures.Jvm;
import carom.net.transport.Impairment;
import carom.replay.Block;
import carom.replay.RecordingException;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.server.CaromMain;
import carom.server.metrics.Counter;
import carom.suite.Needs;
import carom.testkit.Stepper;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.slf4j.LoggerFactory;

/** Goal: {@code --record} writes what {@code carom replay} plays. Method: both, with bots. */
@Needs("waits")
final class RecordingFileTest {
  @TempDir private Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int replay(Path file, String... more) {
    String[] args = new String[more.length + 2];
    args[0] = "replay";
    args[1] = file.toString();
    System.arraycopy(more, 0, args, 2, more.length);
    return CaromMain.run(new PrintWriter(out), new PrintWriter(err), args);
  }

  private Path record(double seconds) throws Exception {
    Path file;
    try (Stepper stepper = Stepper.of("platformer")) {
      file = stepper.server().record(folder).get(0);
      assertThrows(
          FileAlreadyExistsException.class,
          () -> new RecordingFile(file),
          "nothing is overwritten");
      stepper.join("bot", Impairment.NONE.withLoss(5), new Bot(1));
      stepper.run(seconds);
    }
    return file;
  }

  @Test
  void whatTheServerRecordsTheCommandPlays() throws Exception {
    Path file = record(7);
    assertTrue(file.getFileName().toString().matches("platformer-\\d{8}-\\d{6}\\.carom"));
    assertEquals(0, replay(file), err::toString);
    assertTrue(out.toString().contains("game=platformer"), out::toString);
    assertTrue(out.toString().contains("OK: "), out::toString);
    assertTrue(out.toString().contains("End of the recording: SERVER_STOPPING"), out::toString);
  }

  @Test
  void aTornFileIsPlayedUpToItsLastWholeBlock() throws Exception {
    Path file = record(3);
    byte[] bytes = Files.readAllBytes(file);
    Files.write(file, Arrays.copyOf(bytes, bytes.length - 100));
    assertEquals(0, replay(file), err::toString);
    assertTrue(out.toString().contains("torn"), out::toString);
  }

  @Test
  void aFileThatGrowsTooLargeIsCut() throws Exception {
    byte[] noise = new byte[2_000];
    new Random(1).nextBytes(noise);
    Path path = folder.resolve("large.carom");
    int taken = 0;
    try (RecordingFile file = new RecordingFile(path, 10_000)) {
      while (taken < 100 && file.take(Block.TICKS, noise, noise.length)) {
        while (file.endOf(taken) < 0) {
          Thread.sleep(1);
        }
        taken++;
      }
      assertTrue(file.cutReason().contains("10000 bytes"), file::cutReason);
    }
    assertEquals(5, taken, "the fifth block of 2,000 bytes passes the limit");
    assertTrue(Files.size(path) > 10_000 && Files.size(path) < 11_000, "" + Files.size(path));
  }

  @Test
  void theCommandSaysWhatIsWrong() throws Exception {
    assertEquals(2, replay(folder.resolve("missing.carom")));
    assertTrue(err.toString().contains("there is no file"), err::toString);
    Path file = record(1);
    byte[] bytes = Files.readAllBytes(file);
    assertEquals(2, replay(Files.write(folder.resolve("z"), new byte[20])));
    assertTrue(err.toString().contains("is no recording"), err::toString);
    bytes[40] ^= 1;
    assertEquals(2, replay(Files.write(folder.resolve("w"), bytes)));
    assertTrue(err.toString().contains("checksum"), err::toString);
    assertEquals(2, replay(file, "--quick"));
    assertNotEquals(0, CaromMain.run(new PrintWriter(out), new PrintWriter(err)));
  }

  @Test
  void aDiskThatFailsCutsTheRecordingAndNothingElse() throws Exception {
    Path file = folder.resolve("full.carom");
    byte[] block = new byte[1 << 20];
    new Random(1).nextBytes(block);
    RecordingFile recording = new RecordingFile(file);
    int taken = 0;
    while (taken < 1_000 && recording.take(Block.TICKS, block, block.length)) {
      taken++; // faster than any disk and compressor: the queue fills up
    }
    assertTrue(taken < 1_000 && taken >= RecordingFile.QUEUE, "taken=" + taken);
    assertTrue(recording.cutReason().contains("blocks wait"));
    assertFalse(recording.take(Block.TICKS, block, 1));
    recording.close();
    recording.close();
    assertTrue(Files.size(file) > taken * (1L << 20));
  }

  /** Hands blocks to a file, faster than any disk takes them, until it is cut. */
  private static void fill(RecordingFile file) {
    byte[] block = new byte[1 << 20];
    new Random(1).nextBytes(block);
    int taken = 0;
    while (taken < 1_000 && file.take(Block.TICKS, block, block.length)) {
      taken++;
    }
    assertTrue(file.cutReason().contains("blocks wait"), "taken=" + taken);
  }

  @Test
  void aDiskThatWasTooSlowForAMomentLeavesAGapBetweenTwoFiles() throws Exception {
    List<RecordingFile> made = new ArrayList<>();
    Logger log = (Logger) LoggerFactory.getLogger("carom.server.room.RoomRecording");
    ListAppender<ILoggingEvent> lines = new ListAppender<>();
    lines.start();
    log.addAppender(lines);
    try (Stepper stepper = Stepper.of("arena")) {
      stepper
          .room()
          .record(
              () -> {
                made.add(new RecordingFile(folder.resolve("part" + made.size() + ".carom")));
                return made.get(made.size() - 1);
              });
      stepper.join("bot", Impairment.NONE, new Bot(1));
      stepper.run(2);
      fill(made.get(0));
      stepper.run(2);
      assertEquals(1, stepper.count(Counter.RECORDINGS_CUT));
      made.get(0).close(); // waits for the disk
      stepper.run(2);
      assertEquals(2, made.size(), "the game goes on in another file");
    } finally {
      log.detachAppender(lines);
    }
    made.get(1).close();
    assertEquals(0, replay(made.get(1).path()), err::toString);
    List<String> texts = lines.list.stream().map(ILoggingEvent::getFormattedMessage).toList();
    assertTrue(
        texts
            .get(0)
            .contains("the disk is too slow: 16 blocks wait; the game goes on, and another"),
        () -> texts.toString());
  }

  @Test
  void aRecordingIsFollowedWhileItIsWritten() throws Exception {
    try (Stepper stepper = Stepper.of("arena")) {
      Path file = stepper.server().record(folder.resolve("live.carom")).get(0);
      stepper.join("bot", Impairment.NONE, new Bot(1));
      try (RecordingReader reader = openWritten(file)) {
        Replay replay = new Replay(reader);
        for (int i = 0; i < 40 && replay.simulation().tick() < 240; i++) {
          stepper.run(0.5);
          Thread.sleep(20); // for the thread that writes
          while (replay.step() == Replay.Progress.TICK) {
            assertNull(replay.divergence());
          }
        }
        assertTrue(replay.simulation().tick() >= 240);
        assertTrue(stepper.room().simulation().tick() >= replay.simulation().tick());
      }
    }
  }

  /** Opens a recording whose header is being written by another thread. */
  private static RecordingReader openWritten(Path file) throws Exception {
    for (int left = 500; ; left--) {
      try {
        return RecordingReader.open(file);
      } catch (RecordingException e) {
        if (left == 0) {
          throw e;
        }
        Thread.sleep(10);
      }
    }
  }

  @Test
  void aFolderGetsFilesWithNamesOfTheirOwn() {
    Path file = folder.resolve("one.carom");
    assertEquals(file, RecordingFile.fileFor(file, "arena", "2"));
    assertTrue(
        RecordingFile.fileFor(folder, "scene:pyramid", "2")
            .getFileName()
            .toString()
            .matches("scene-pyramid-\\d{8}-\\d{6}-room2\\.carom"));
  }

  @Test
  void otherJvmsComputeTheSameGame() throws Exception {
    Path file = record(4);
    for (String mode : new String[] {"-Xint", "-XX:TieredStopAtLevel=1"}) {
      Process process =
          new ProcessBuilder(Jvm.command(List.of(mode), CaromMain.class, "replay", file.toString()))
              .redirectErrorStream(true)
              .start();
      String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      assertEquals(0, process.waitFor(), mode + ": " + said);
      assertTrue(said.contains("OK: "), said);
    }
  }
}
