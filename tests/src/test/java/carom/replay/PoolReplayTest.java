package carom.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import carom.game.Games;
import carom.net.protocol.Protocol;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a recording of a level with pools is computed again bit for bit. Method: a player swims
 * about while spouts open and close; every tick's hash, which covers the particles, is compared.
 */
final class PoolReplayTest {
  private static final int TICKS = 900;

  @TempDir private Path folder;

  @Test
  void aRecordingOfWaterIsComputedAgainBitForBit() throws Exception {
    SimulationHost s =
        new SimulationHost(
            Games.create("platformer"), Level.builtIn("sluice"), 5, 60, Role.AUTHORITY);
    Blocks blocks = new Blocks();
    Recorder recorder = new Recorder(s, RecordingHeader.of(s, 5, Protocol.physicsDigest()), blocks);
    s.addJournal(recorder);
    HostPlayer ann = s.join("Ann");
    for (int tick = 0; tick < TICKS; tick++) {
      ann.input().move(tick / 200 % 2 == 0 ? 1 : -1, 0);
      s.step();
    }
    recorder.end("test");
    try (RecordingReader reader = RecordingReader.open(blocks.write(folder.resolve("a.carom")))) {
      Replay replay = new Replay(reader);
      while (replay.step() == Replay.Progress.TICK) {
        assertNull(replay.divergence(), () -> "tick " + replay.simulation().tick());
      }
      assertEquals(TICKS, replay.equalTicks());
      assertEquals(s.stateHash(), replay.simulation().stateHash());
      assertEquals(
          s.pools().get(0).particles().stateHash(),
          replay.simulation().pools().get(0).particles().stateHash());
    }
  }
}
