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
import carom.sim.message.PlayerColour;
import carom.sim.message.PlayerRole;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a recording in which players change role, team and readiness is computed again bit for bit.
 * Method: participants come, go, ask and are moved at random; every tick's hash is compared.
 */
final class RosterReplayTest {
  private static final int TICKS = 3_700; // a whole state is written in between
  private static final int MOST = 6;

  @TempDir private Path folder;

  private int changes;

  private static SimulationHost arena() throws Exception {
    return new SimulationHost(Games.create("arena"), Level.builtIn("arena"), 5, 60, Role.AUTHORITY);
  }

  private static Recorder record(SimulationHost s, Blocks blocks) {
    Recorder recorder = new Recorder(s, RecordingHeader.of(s, 5, Protocol.physicsDigest()), blocks);
    s.addJournal(recorder);
    return recorder;
  }

  private void happen(SimulationHost s, Random random) {
    int id = random.nextInt(MOST);
    HostPlayer p = s.participant(id);
    if (p == null) {
      if (random.nextBoolean()) {
        s.join(id, "Player " + id);
      } else {
        s.joinAsSpectator(id, "Spectator " + id);
      }
      return;
    }
    PlayerRole before = p.role();
    PlayerRole wanted = PlayerRole.values()[random.nextInt(2)];
    switch (random.nextInt(7)) {
      case 0 -> s.role(p, wanted);
      case 1 -> s.receive(p, BuiltInKinds.ROLE.of(wanted));
      case 2 -> s.receive(p, BuiltInKinds.TEAM.of(random.nextInt(4)));
      case 3 -> s.receive(p, BuiltInKinds.READY.of(random.nextBoolean()));
      case 4 -> s.receive(p, BuiltInKinds.COLOUR.of(PlayerColour.of(random.nextInt(12))));
      case 5 -> {
        if (random.nextInt(8) == 0) {
          s.leave(p);
        }
      }
      default -> p.input().move(random.nextFloat() - 0.5f, random.nextFloat() - 0.5f);
    }
    changes += before == p.role() ? 0 : 1;
  }

  private void play(SimulationHost s, Random random, int ticks) {
    for (int tick = 0; tick < ticks; tick++) {
      if (random.nextInt(4) == 0) {
        happen(s, random);
      }
      s.step();
    }
  }

  private void assertEqualReplay(Blocks blocks, int ticks, SimulationHost played) throws Exception {
    try (RecordingReader reader = RecordingReader.open(blocks.write(folder.resolve("a.carom")))) {
      Replay replay = new Replay(reader);
      while (replay.step() == Replay.Progress.TICK) {
        assertNull(replay.divergence(), () -> "tick " + replay.simulation().tick());
      }
      assertEquals(ticks, replay.equalTicks());
      assertEquals(played.stateHash(), replay.simulation().stateHash());
      for (int id = 0; id < MOST; id++) {
        HostPlayer there = played.participant(id);
        HostPlayer here = replay.simulation().participant(id);
        assertEquals(there == null, here == null);
        assertEquals(there == null ? null : there.role(), here == null ? null : here.role());
        assertEquals(there == null ? null : there.colour(), here == null ? null : here.colour());
      }
    }
  }

  @Test
  void aReplayChangesRolesTeamsAndReadinessAtTheSameTicks() throws Exception {
    Random random = new Random(11);
    SimulationHost s = arena();
    Blocks blocks = new Blocks();
    Recorder recorder = record(s, blocks);
    play(s, random, TICKS);
    recorder.end("test");
    assertTrue(changes > 20, "seed=11 changes=" + changes);
    assertEqualReplay(blocks, TICKS, s);
  }

  @Test
  void aRecordingBeginsAmongSpectators() throws Exception {
    Random random = new Random(12);
    SimulationHost s = arena();
    play(s, random, 300);
    s.joinAsSpectator(MOST + 1, "Watcher");
    Blocks blocks = new Blocks();
    Recorder recorder = record(s, blocks);
    play(s, random, 400);
    recorder.end("test");
    assertEqualReplay(blocks, 400, s);
  }

  @Test
  void aRoleOfNobodyIsDamage() throws Exception {
    SimulationHost s = arena();
    Blocks blocks = new Blocks();
    Recorder recorder = record(s, blocks);
    HostPlayer ann = s.join("Ann");
    s.role(ann, PlayerRole.SPECTATOR);
    s.step();
    recorder.end("test");
    for (Blocks.Raw block : blocks.blocks) {
      byte[] bytes = block.bytes();
      for (int i = 0; i + 2 < bytes.length && block.type() == Block.TICKS; i++) {
        if (bytes[i] == Block.ROLE && bytes[i + 1] == 0 && bytes[i + 2] == 1) {
          bytes[i + 1] = 9; // no such player
          break;
        }
      }
    }
    try (RecordingReader reader = RecordingReader.open(blocks.write(folder.resolve("b.carom")))) {
      Replay replay = new Replay(reader);
      String why = assertThrows(RecordingException.class, replay::step).getMessage();
      assertTrue(why.contains("player 9 changes without having joined"), why);
    }
  }
}
