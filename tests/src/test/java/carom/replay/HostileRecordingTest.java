package carom.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Slice;
import carom.game.Games;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: no bytes make a replay do anything but end or say what is wrong. Method: a good recording,
 * cut off at every length, damaged at random below and above the checksums, and foreign files.
 */
final class HostileRecordingTest {
  private static final long SEED = Long.getLong("carom.seed", 42);

  @TempDir private Path folder;
  private final Blocks blocks = new Blocks();
  private byte[] good;

  @BeforeEach
  void record() throws Exception {
    SimulationHost s =
        new SimulationHost(Games.create("arena"), Level.builtIn("arena"), 7, 60, Role.AUTHORITY);
    Recorder recorder = new Recorder(s, RecordingHeader.of(s, 7, 99), blocks);
    s.addJournal(recorder);
    Random random = new Random(SEED);
    for (int tick = 1; tick <= 200; tick++) {
      if (tick % 20 == 1) {
        s.join("player" + tick);
      } else if (tick % 50 == 0) {
        s.leave(s.player(1));
      }
      for (int id = 0; id < s.playerCapacity(); id++) {
        HostPlayer p = s.player(id);
        if (p != null && random.nextInt(8) == 0) {
          p.input().unpack(random.nextLong());
          p.viewDelay(random.nextInt(300));
        }
      }
      s.step();
    }
    recorder.end("over");
    good = Files.readAllBytes(blocks.write(folder.resolve("good.carom")));
  }

  /** Plays a file to its end; returns the ticks it had. */
  private int play(byte[] bytes, Replay.Progress[] end) throws IOException {
    Path file = Files.write(folder.resolve("test.carom"), bytes);
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      Replay.Progress progress;
      do {
        progress = replay.step();
      } while (progress == Replay.Progress.TICK && !replay.isDecided());
      if (end != null) {
        end[0] = progress;
        assertEquals(null, replay.divergence());
      }
      return replay.simulation().tick();
    }
  }

  @Test
  void aTornTailIsReadUpToTheLastWholeBlock() throws Exception {
    Replay.Progress[] end = new Replay.Progress[1];
    assertEquals(200, play(good, end));
    assertEquals(Replay.Progress.END, end[0]);
    Random random = new Random(SEED);
    int last = 0;
    for (int i = 0; i < 40; i++) {
      int length =
          i < 20
              ? good.length - 1 - i * 7
              : Block.PREAMBLE_BYTES + random.nextInt(good.length - 12);
      byte[] torn = Arrays.copyOf(good, length);
      int ticks;
      try {
        ticks = play(torn, end);
      } catch (RecordingException e) {
        assertTrue(e.getMessage().contains("before its header"), e.getMessage());
        continue;
      }
      assertEquals(Replay.Progress.WAIT, end[0], "length=" + length);
      assertEquals(0, ticks % 60 == 0 ? 0 : 200 - ticks, "length=" + length + " ticks=" + ticks);
      last = Math.max(last, ticks);
      // The same with zeros in the place of what the disk did not get in time.
      assertEquals(ticks, play(Arrays.copyOf(torn, length + random.nextInt(20_000)), null));
    }
    assertEquals(200, last);
  }

  @Test
  void nothingMayFollowTheEnd() {
    Random random = new Random(SEED);
    for (int more : new int[] {1, 8, 17, 30_000}) {
      byte[] longer = Arrays.copyOf(good, good.length + more);
      for (int i = good.length; i < longer.length; i++) {
        longer[i] = (byte) random.nextInt();
      }
      RecordingException e = assertThrows(RecordingException.class, () -> play(longer, null));
      assertTrue(e.getMessage().contains(more + " bytes follow the end"), e.getMessage());
    }
  }

  @Test
  void aFileThatGrowsIsFollowed() throws Exception {
    Path file = folder.resolve("growing.carom");
    Files.write(file, Arrays.copyOf(good, good.length / 2));
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      int length = good.length / 2;
      while (true) {
        Replay.Progress progress = replay.step();
        if (progress == Replay.Progress.END) {
          break;
        } else if (progress == Replay.Progress.WAIT) {
          length = Math.min(good.length, length + 100);
          Files.write(file, Arrays.copyOf(good, length));
        }
      }
      assertEquals(200, replay.simulation().tick());
      assertEquals(null, replay.divergence());
    }
  }

  @Test
  void damageBelowTheChecksumIsSeen() throws Exception {
    Random random = new Random(SEED);
    for (int i = 0; i < 300; i++) {
      byte[] damaged = good.clone();
      for (int n = random.nextInt(3); n >= 0; n--) {
        damaged[random.nextInt(damaged.length)] ^= (byte) (1 << random.nextInt(8));
      }
      try {
        play(damaged, new Replay.Progress[1]); // up to where the tail could be torn
      } catch (RecordingException e) {
        assertTrue(e.getMessage().startsWith("test.carom"), e.getMessage());
      }
    }
  }

  @Test
  void damageAboveTheChecksumThrowsNothingElse() throws Exception {
    Random random = new Random(SEED);
    int refused = 0;
    int damaged = (int) Slice.of(150, 400);
    for (int i = 0; i < damaged; i++) {
      Blocks bad = new Blocks();
      bad.blocks.addAll(blocks.blocks);
      int which = random.nextInt(bad.blocks.size());
      Blocks.Raw raw = bad.blocks.get(which);
      byte[] bytes = raw.bytes().clone();
      for (int n = random.nextInt(4); n >= 0; n--) {
        bytes[random.nextInt(bytes.length)] = (byte) random.nextInt();
      }
      if (random.nextInt(4) == 0) {
        bytes = Arrays.copyOf(bytes, 1 + random.nextInt(bytes.length + 20));
      }
      Block type = random.nextInt(10) == 0 ? Block.of(random.nextInt(4)) : raw.type();
      bad.blocks.set(which, new Blocks.Raw(type, bytes));
      if (random.nextInt(10) == 0) {
        bad.blocks.remove(random.nextInt(bad.blocks.size()));
      }
      try {
        play(Files.readAllBytes(bad.write(folder.resolve("bad.carom"))), null);
      } catch (RecordingException e) {
        refused++;
      }
    }
    assertTrue(refused > damaged / 4, "refused=" + refused + " seed=" + SEED);
  }

  @Test
  void noiseIsRefused() {
    Random random = new Random(SEED);
    for (int i = 0; i < 500; i++) {
      byte[] noise = new byte[random.nextInt(2_000)];
      random.nextBytes(noise);
      if (i % 2 == 0 && noise.length > 12) {
        System.arraycopy(good, 0, noise, 0, 12);
      }
      assertThrows(RecordingException.class, () -> play(noise, null), "seed=" + SEED + " i=" + i);
    }
  }

  @Test
  void aBombIsRefusedBeforeItGoesOff() throws Exception {
    Blocks bomb = new Blocks();
    bomb.blocks.add(blocks.blocks.get(0));
    bomb.blocks.add(new Blocks.Raw(Block.KEYFRAME, new byte[Block.MAX_BYTES]));
    byte[] bytes = Files.readAllBytes(bomb.write(folder.resolve("bomb.carom")));
    assertTrue(bytes.length < 100_000);
    assertThrows(RecordingException.class, () -> play(bytes, null));
    byte[] boast = good.clone();
    ByteBuffer.wrap(boast).putInt(Block.PREAMBLE_BYTES + 1, Integer.MAX_VALUE);
    assertTrue(
        assertThrows(RecordingException.class, () -> play(boast, null))
            .getMessage()
            .contains("length=2147483647"));
  }

  @Test
  void foreignVersionsAndFilesAreNamed() {
    byte[] other = good.clone();
    other[11] = 9;
    String message = assertThrows(RecordingException.class, () -> play(other, null)).getMessage();
    assertTrue(message.contains("version=9, this build reads 5"), message);
    message =
        assertThrows(RecordingException.class, () -> play(new byte[] {1, 2, 3}, null)).getMessage();
    assertTrue(message.contains("no recording"), message);
    message =
        assertThrows(
                RecordingException.class,
                () -> RecordingReader.open(folder.resolve("missing.carom")))
            .getMessage();
    assertTrue(message.contains("no file"), message);
  }
}
