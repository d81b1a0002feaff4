package carom.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.arena.ArenaGame;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.level.Level;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A recording is of a game with certain fields; with others it is refused by the field's name. */
final class RecordedFieldsTest {
  private static RecordingHeader header() throws Exception {
    SimulationHost s =
        new SimulationHost(new ArenaGame(), Level.builtIn("arena"), 1, 60, Role.AUTHORITY);
    return RecordingHeader.of(s, 1, 2);
  }

  private static RecordingHeader withFields(RecordingHeader h, List<String> fields) {
    return new RecordingHeader(
        h.physicsDigest(),
        h.game(),
        h.levelName(),
        h.levelHash(),
        h.level(),
        h.seed(),
        h.tickRate(),
        fields);
  }

  @Test
  void aHeaderHoldsTheDeclarations() throws Exception {
    RecordingHeader header = header();
    assertTrue(header.fields().contains("match.goals count 0..5 x3 to ALL"), "" + header.fields());
    assertEquals(header.fields(), header.start().schema().lines());
    ByteSink out = new ByteSink();
    header.write(out);
    ByteSource in = new ByteSource();
    in.set(out.array(), out.length());
    assertEquals(header, RecordingHeader.read(in));
  }

  @Test
  void aRecordingOfOtherFieldsIsRefusedByName() throws Exception {
    RecordingHeader header = header();
    List<String> other = new ArrayList<>(header.fields());
    int goals = other.indexOf("match.goals count 0..5 x3 to ALL");
    other.set(goals, "match.goals count 0..9 x3 to ALL");
    String message =
        assertThrows(RecordingException.class, () -> withFields(header, other).start())
            .getMessage();
    assertTrue(message.contains("game arena has other fields than the recording"), message);
    assertTrue(message.contains("field match.goals is"), message);
  }
}
