package carom.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.BigWorlds;
import carom.game.Games;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.level.Level;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: what checkpoints cost is known and bounded. Method: a minute of play with twelve players,
 * checkpoints every 5 s; prints what the room's thread computes for each (time of the processor),
 * what the disk gets in a minute, and how long it takes to compute 5 s of log again.
 */
class CheckpointCostTest {
  private static final int PLAYERS = 12;
  private static final int RATE = 60;
  private static final int INTERVAL_TICKS = 5 * RATE;
  private static final int CHECKPOINTS = 12;

  @TempDir Path folder;

  /** Returns the time for which this thread has had a processor, as the machine may be busy. */
  private static long cpuNs() {
    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
  }

  private static SimulationHost start(Level level) {
    SimulationHost s =
        new SimulationHost(Games.create(level.gameName()), level, 7, RATE, Role.AUTHORITY);
    for (int i = 0; i < PLAYERS; i++) {
      s.join("p" + i);
    }
    return s;
  }

  private static void step(SimulationHost s) {
    for (int id = 0; id < PLAYERS; id++) {
      int tick = s.tick();
      s.player(id).input().move((tick / 7 + id) % 3 - 1, (tick / 11 + id) % 3 - 1);
    }
    s.step();
  }

  private void measure(String what, Level level, long mostBytesPerCheckpoint) throws Exception {
    SimulationHost s = start(level);
    for (int i = 0; i < RATE; i++) {
      step(s);
    }
    RecordingHeader header = RecordingHeader.of(s, 7, 99);
    ByteArrayOutputStream disk = new ByteArrayOutputStream();
    BlockWriter[] writer = {new BlockWriter(disk)};
    BlockSink sink =
        (type, bytes, length) -> {
          try {
            writer[0].write(type, Arrays.copyOf(bytes, length), length);
          } catch (IOException e) {
            throw new AssertionError(e);
          }
          return true;
        };
    long[] inSinkNs = {0};
    BlockSink timed =
        (type, bytes, length) -> {
          long beginNs = cpuNs();
          boolean taken = sink.take(type, bytes, length);
          inSinkNs[0] += cpuNs() - beginNs;
          return taken;
        };
    Recorder recorder = new Recorder(s, header, timed, Recorder.Intervals.LOG);
    s.addJournal(recorder);
    long[] tookNs = new long[CHECKPOINTS];
    long bytes = 0;
    for (int n = 0; n < CHECKPOINTS; n++) {
      for (int i = 0; i < INTERVAL_TICKS; i++) {
        step(s);
      }
      recorder.end("CHECKPOINT");
      bytes += disk.size();
      if (n == CHECKPOINTS - 1) {
        Files.write(folder.resolve("slot"), disk.toByteArray());
      }
      disk.reset();
      writer[0] = new BlockWriter(disk);
      inSinkNs[0] = 0;
      long beginNs = cpuNs();
      recorder.goOn(s, "CHECKPOINT", header, timed);
      tookNs[n] = cpuNs() - beginNs - inSinkNs[0];
    }
    Arrays.sort(tookNs);
    long beginNs = cpuNs();
    SimulationHost again = new SimulationHost(s.game(), level, 7, RATE, Role.AUTHORITY);
    try (RecordingReader reader = RecordingReader.open(folder.resolve("slot"))) {
      Replay replay = new Replay(reader, again);
      while (replay.step() == Replay.Progress.TICK) {}
      assertEquals(INTERVAL_TICKS, replay.equalTicks());
    }
    long resumeMs = (cpuNs() - beginNs) / 1_000_000;
    System.out.printf(
        "%s: %d bodies, taking the state %.2f ms (median), %.2f ms (most); %d kB a minute; 5 s of"
            + " log again in %d ms%n",
        what,
        s.entityCount(),
        tookNs[CHECKPOINTS / 2] * 1e-6,
        tookNs[CHECKPOINTS - 1] * 1e-6,
        bytes / 1_000,
        resumeMs);
    assertTrue(bytes / CHECKPOINTS < mostBytesPerCheckpoint, "bytes=" + bytes / CHECKPOINTS);
  }

  @Test
  void aCheckpointOfTheArenaIsSmall() throws Exception {
    measure("arena", Level.builtIn("arena"), 100_000);
  }

  @Test
  void aCheckpointOfFiveThousandBodiesFitsTheDisk() throws Exception {
    measure("crates", BigWorlds.crates(5_000, 300, 1), 8_000_000);
  }
}
