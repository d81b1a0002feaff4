package carom.server.recording;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.arena.ArenaGame;
import carom.replay.Recorder;
import carom.replay.RecordingHeader;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.level.Level;
import carom.suite.Needs;
import java.io.ByteArrayOutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a spectator that comes late need not fetch the past. Method: the test replays the bytes
 * that the recording shows from there on.
 */
@Needs("waits")
final class DelayedRecordingTest {
  private static final int DELAY = 60;
  private static final int PIECE = 1_000;

  @TempDir private Path folder;

  private static byte[] all(DelayedRecording recording, long skipped, int now) throws Exception {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    byte[] piece;
    do {
      piece = recording.read(skipped, out.size(), PIECE, now);
      out.writeBytes(piece);
    } while (piece.length > 0);
    return out.toByteArray();
  }

  @Test
  void whoComesLateBeginsWithTheLastStateShown() throws Exception {
    SimulationHost s =
        new SimulationHost(new ArenaGame(), Level.builtIn("arena"), 7, 60, Role.AUTHORITY);
    DelayedRecording recording =
        new DelayedRecording(new RecordingFile(folder.resolve("all.carom")), s::tick, false);
    recording.delay(DELAY);
    Recorder recorder = new Recorder(s, RecordingHeader.of(s, 7, 99), recording);
    s.addJournal(recorder);
    s.join(0, "Ann");
    int minute = Recorder.STATE_SECONDS * 60;
    for (int i = 0; i < minute + 200; i++) {
      s.step();
      while (recording.file().endOf(i / 60) < 0) {
        Thread.sleep(1); // a block a second: the thread that writes must not fall behind
      }
    }
    recorder.end("STOPPED");
    recording.file().close();

    assertEquals(
        0, recording.skippableBytes(minute + DELAY - 1), "the state is too young to be shown");
    long skipped = recording.skippableBytes(minute + DELAY + 120);
    assertTrue(skipped > 10_000, "skipped=" + skipped);
    byte[] whole = Files.readAllBytes(folder.resolve("all.carom"));
    int late = s.tick() + DELAY;
    assertArrayEquals(whole, all(recording, 0, late), "who was there before reads all");
    byte[] rest = all(recording, skipped, late);
    assertEquals(whole.length - skipped, rest.length);
    Path file = Files.write(folder.resolve("rest.carom"), rest);
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      assertEquals(minute, replay.firstTick());
      while (replay.step() == Replay.Progress.TICK) {
        assertNull(replay.divergence());
      }
      assertEquals("STOPPED", reader.reason());
      assertEquals(s.tick(), replay.simulation().tick());
      assertEquals(s.stateHash(), replay.simulation().stateHash());
    }
    recording.close();
  }
}
