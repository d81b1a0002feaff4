package carom.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.net.protocol.Protocol;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Emote;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a recording holds the messages of players, so that a replay hears the same at the same
 * ticks. Method: two players write at random; what the game sends in each tick is compared.
 */
final class MessageReplayTest {
  @TempDir private Path folder;

  private static SimulationHost arena() throws Exception {
    return new SimulationHost(Games.create("arena"), Level.builtIn("arena"), 5, 60, Role.AUTHORITY);
  }

  private static void note(SimulationHost s, List<String> to) {
    s.outbox()
        .drainMessages(d -> to.add(s.tick() + " " + d.message() + " " + d.recipients() + d.id()));
  }

  @Test
  void aReplayHearsTheSameMessagesAtTheSameTicks() throws Exception {
    long seed = 3;
    Random random = new Random(seed);
    SimulationHost s = arena();
    Blocks blocks = new Blocks();
    Recorder recorder = new Recorder(s, RecordingHeader.of(s, 5, Protocol.physicsDigest()), blocks);
    s.addJournal(recorder);
    HostPlayer[] players = {s.join("Ann"), s.join("Bob")};
    List<String> played = new ArrayList<>();
    for (int tick = 1; tick <= 200; tick++) {
      for (int n = random.nextInt(4); n > 0; n--) {
        boolean team = random.nextBoolean();
        s.receive(
            players[random.nextInt(2)],
            random.nextInt(3) == 0
                ? BuiltInKinds.EMOTE.of(Emote.WOW)
                : BuiltInKinds.SAY.of(team, "line " + tick + " of " + n));
      }
      s.step();
      note(s, played);
    }
    recorder.end("test");
    assertTrue(played.size() > 100, "seed=" + seed + " messages=" + played.size());
    List<String> replayed = new ArrayList<>();
    try (RecordingReader reader = RecordingReader.open(blocks.write(folder.resolve("a.carom")))) {
      Replay replay = new Replay(reader);
      while (replay.step() == Replay.Progress.TICK) {
        note(replay.simulation(), replayed);
      }
      assertNull(replay.divergence());
      assertEquals(200, replay.equalTicks());
    }
    assertEquals(played, replayed);
  }

  @Test
  void aMessageThatTheGameDoesNotKnowIsDamage() throws Exception {
    SimulationHost s = arena();
    Blocks blocks = new Blocks();
    Recorder recorder = new Recorder(s, RecordingHeader.of(s, 5, Protocol.physicsDigest()), blocks);
    s.addJournal(recorder);
    HostPlayer ann = s.join("Ann");
    s.receive(ann, BuiltInKinds.SAY.of(false, "hello there"));
    s.step();
    recorder.end("test");
    for (Blocks.Raw block : blocks.blocks) {
      byte[] bytes = block.bytes();
      for (int i = 0; i + 4 < bytes.length && block.type() == Block.TICKS; i++) {
        if (bytes[i] == Block.MESSAGE && bytes[i + 2] == 14) { // index, team, length, 11 characters
          bytes[i + 3] = (byte) 200; // no such kind
        }
      }
    }
    try (RecordingReader reader = RecordingReader.open(blocks.write(folder.resolve("b.carom")))) {
      Replay replay = new Replay(reader);
      String why = assertThrows(RecordingException.class, replay::step).getMessage();
      assertTrue(why.contains("no message of this game"), why);
    }
  }
}
