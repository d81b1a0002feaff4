package carom.client.link;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.PackedLevel;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage.LevelChunk;
import carom.net.protocol.ServerMessage.Welcome;
import carom.sim.level.Level;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

/** Goal: a rotation loads each level once, and memory is bounded. */
class LevelDownloadTest {
  private final LevelDownload download = new LevelDownload();

  private static Level level(int number) throws Exception {
    String json =
        String.format(
            Locale.ROOT,
            """
            {"name": "Level %d", "game": "arena", "gravity": [0, 0],
             "bounds": {"min": [-9, -9], "max": [9, 9]}, "spawns": [{"at": [0, 0]}],
             "statics": [{"at": [0, -2], "shape": {"type": "box", "width": 9, "height": 1}}]}
            """,
            number);
    return Level.parse("level.json", json.getBytes(StandardCharsets.UTF_8));
  }

  private Welcome welcome(Level level) {
    byte[] packed = PackedLevel.pack(level.source());
    return new Welcome(
        1,
        2,
        3,
        60,
        "room",
        1,
        0,
        0,
        0,
        0,
        0,
        "arena",
        level.name(),
        level.contentHash(),
        level.source().length,
        packed.length,
        0,
        0,
        false,
        List.of());
  }

  private void load(Level level) {
    assertFalse(download.begin(welcome(level)), level.name() + " isn't here yet");
    byte[] packed = PackedLevel.pack(level.source());
    LevelDownload.Status progress = LevelDownload.Status.LOADING;
    for (int from = 0; from < packed.length; from += ProtocolLimits.MAX_LEVEL_CHUNK_BYTES) {
      int to = Math.min(packed.length, from + ProtocolLimits.MAX_LEVEL_CHUNK_BYTES);
      progress = download.add(new LevelChunk(from, Arrays.copyOfRange(packed, from, to)));
    }
    assertEquals(LevelDownload.Status.DONE, progress, download.problem());
  }

  @Test
  void aRotationLoadsEachLevelOnce() throws Exception {
    for (int number = 0; number < 3; number++) {
      load(level(number));
    }
    for (int number = 0; number < 6; number++) {
      assertTrue(download.begin(welcome(level(number % 3))));
      assertEquals("Level " + number % 3, download.level().name());
    }
  }

  @Test
  void theLevelThatWasUsedLongestAgoIsForgottenFirst() throws Exception {
    for (int number = 0; number < 16; number++) {
      load(level(number));
    }
    assertTrue(download.begin(welcome(level(0))), "used again");
    load(level(16));
    assertTrue(download.begin(welcome(level(0))));
    assertFalse(download.begin(welcome(level(1))));
  }
}
