package carom.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.net.protocol.Protocol;
import carom.server.ReplayCommand;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.text.Texts;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/**
 * Goal: the author of a recording writes nothing to the terminal of the person who plays it but
 * characters that one sees. Method: escape sequences in every text that a recording has, and all
 * that {@code carom replay} prints.
 */
final class ReplayWordsTest {
  private static final String EVIL = "\u001b]0;owned\u0007\u001b[2J\u202e\u009b31m";

  @TempDir private Path folder;

  private String printed(String game, String levelName, String field, int exitCode)
      throws IOException, LevelException {
    SimulationHost s =
        new SimulationHost(Games.create("arena"), Level.builtIn("arena"), 7, 60, Role.AUTHORITY);
    RecordingHeader good = RecordingHeader.of(s, 7, Protocol.physicsDigest());
    RecordingHeader header =
        new RecordingHeader(
            good.physicsDigest(),
            game,
            levelName,
            good.levelHash(),
            good.level(),
            7,
            60,
            field == null ? good.fields() : List.of(field));
    Blocks blocks = new Blocks();
    Recorder recorder = new Recorder(s, header, blocks);
    s.addJournal(recorder);
    s.join("player" + EVIL);
    for (int tick = 0; tick < 10; tick++) {
      s.step();
    }
    recorder.end("over" + EVIL);
    Path file = blocks.write(folder.resolve("evil.carom"));
    StringWriter text = new StringWriter();
    PrintWriter out = new PrintWriter(text);
    int code = new CommandLine(new ReplayCommand()).setOut(out).setErr(out).execute("" + file);
    assertEquals(exitCode, code, text.toString());
    for (String line : text.toString().lines().toList()) {
      assertEquals(Texts.clean(line), line);
    }
    return text.toString();
  }

  @Test
  void levelNameAndReasonAreShownWithoutEscapes() throws Exception {
    String text = printed("arena", "arena" + EVIL, null, 0);
    assertTrue(text.contains("level=arena]0;owned[2J31m"), text);
    assertTrue(text.contains("End of the recording: over]0;owned[2J31m"), text);
  }

  @Test
  void soAreAnUnknownGameAndOtherFieldsInTheReasonWhyAFileIsRefused() throws Exception {
    String game = printed("no" + EVIL + "game", "arena", null, 2);
    assertTrue(game.contains("no]0;owned[2J31mgame"), game);
    String field = printed("arena", "arena", "player.evil" + EVIL + " count 0..9 to ALL", 2);
    assertTrue(field.contains("other fields"), field);
  }
}
