package carom.fuzz;

import carom.game.Games;
import carom.replay.Block;
import carom.replay.BlockWriter;
import carom.replay.Recorder;
import carom.replay.RecordingException;
import carom.replay.RecordingHeader;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.level.Level;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Recordings under right checksums: the pieces of an input are blocks, of the kind that the piece
 * says. A replay ends, waits or says what is wrong.
 */
final class RecordingTarget implements FuzzTarget {
  private static final int MOST_TICKS = 200;
  private static final Block[] BLOCKS = Block.values();

  private final Path file;

  RecordingTarget() {
    try {
      file = Files.createTempFile("carom-fuzz", ".carom");
      file.toFile().deleteOnExit();
    } catch (IOException e) {
      throw new IllegalStateException("no file for recordings: " + e.getMessage(), e);
    }
  }

  @Override
  public void take(byte[] data) throws IOException {
    Pieces pieces = new Pieces(data);
    try (BlockWriter writer = new BlockWriter(Files.newOutputStream(file))) {
      for (byte[] piece = pieces.next(); piece != null; piece = pieces.next()) {
        writer.write(BLOCKS[pieces.kind() % BLOCKS.length], piece, piece.length);
      }
    }
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      int ticks = 0;
      while (ticks < MOST_TICKS && replay.step() == Replay.Progress.TICK && !replay.isDecided()) {
        ticks++;
      }
    } catch (RecordingException e) {
      if (e.getMessage() == null || e.getMessage().isEmpty()) {
        throw new AssertionError("a recording was refused without a reason", e);
      }
    }
  }

  @Override
  public List<byte[]> seeds() throws Exception {
    SimulationHost s =
        new SimulationHost(Games.create("arena"), Level.builtIn("arena"), 7, 60, Role.AUTHORITY);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    Recorder recorder =
        new Recorder(
            s,
            RecordingHeader.of(s, 7, 99),
            (type, bytes, length) -> {
              Pieces.add(out, type.ordinal(), java.util.Arrays.copyOf(bytes, length));
              return true;
            });
    s.addJournal(recorder);
    for (int tick = 0; tick < 70; tick++) {
      if (tick == 5) {
        s.join("player");
      }
      s.step();
    }
    recorder.end("over");
    return List.of(out.toByteArray());
  }
}
