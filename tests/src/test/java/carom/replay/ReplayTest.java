package carom.replay;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.client.bots.Bot;
import carom.game.Games;
import carom.net.protocol.GoodbyeReason;
import carom.net.transport.Impairment;
import carom.server.recording.RotatingRecording;
import carom.server.recording.RotationLimit;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneGame;
import carom.sim.scene.Scenes;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: what was played can be computed again, bit for bit, and what was changed is found. Method:
 * whole servers with bots on bad networks, in virtual time, recorded into memory; the oracle is the
 * server's own hash.
 */
final class ReplayTest {
  private static final Impairment BAD =
      Impairment.NONE
          .withBursts(10, 4)
          .withLatency(60, 30)
          .withReorder(5, 5)
          .withSeed(Stepper.SEED);

  @TempDir private Path folder;

  /** Twenty bots: some go, others come, and one is cut off for a while. */
  private static Blocks play(String game, List<Long> hashes) {
    Blocks blocks = new Blocks();
    try (Stepper stepper = Stepper.of(game)) {
      stepper.room().record(blocks);
      List<SimulatedClient> bots = new ArrayList<>();
      for (int i = 0; i < 20; i++) {
        bots.add(stepper.add(bot(i), BAD, new Bot(Stepper.SEED + i)));
      }
      stepper.run(4);
      bots.get(3).leave();
      bots.get(8).leave();
      stepper.blackout(bots.get(11), 2);
      stepper.run(2);
      for (int i = 20; i < 23; i++) {
        stepper.add(bot(i), BAD, new Bot(Stepper.SEED + i));
      }
      stepper.run(5);
      hashes.add((long) stepper.room().simulation().tick());
      hashes.add(stepper.room().simulation().stateHash());
    }
    return blocks;
  }

  private static ClientConfig bot(int i) {
    return ClientConfig.of("bot" + i)
        .withServer("localhost", 0, 0)
        .with(ClientConfig.PREDICTION, PredictionMode.NONE);
  }

  @ParameterizedTest
  @ValueSource(strings = {"arena", "platformer"})
  void whatTwentyBotsPlayedOnABadNetworkIsComputedAgain(String game) throws Exception {
    List<Long> hashes = new ArrayList<>();
    Path file = play(game, hashes).write(folder.resolve("game.carom"));
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      Replay.Progress progress;
      do {
        progress = replay.step();
        assertNull(replay.divergence(), () -> "seed=" + Stepper.SEED + " " + replay.divergence());
      } while (progress == Replay.Progress.TICK);
      assertEquals(Replay.Progress.END, progress);
      assertEquals("SERVER_STOPPING", reader.reason());
      assertFalse(reader.isCut());
      assertEquals(hashes.get(0), replay.simulation().tick());
      assertEquals(hashes.get(1), replay.simulation().stateHash());
      assertTrue(replay.simulation().tick() > 600);
    }
  }

  @Test
  void playersWhoJoinBeforeTheFirstTickDoNotHideWhereTheRecordingBegins() throws Exception {
    // The players of the match before join a next match before its first tick.
    Level level = Level.builtIn("arena");
    SimulationHost s = new SimulationHost(Games.create("arena"), level, 5, 60, Role.AUTHORITY);
    Blocks blocks = new Blocks();
    Recorder recorder = new Recorder(s, RecordingHeader.of(s, 5, 0), blocks);
    s.addJournal(recorder);
    s.join("Ann");
    for (int i = 0; i < 90; i++) {
      s.step();
    }
    recorder.end("NEXT MATCH");
    try (RecordingReader reader = RecordingReader.open(blocks.write(folder.resolve("n.carom")))) {
      Replay replay = new Replay(reader);
      playOn(replay);
      assertEquals(0, replay.firstTick());
      assertEquals(90, replay.simulation().tick());
    }
  }

  /** Recorded from the third second on, at another place than at the start of the room. */
  @ParameterizedTest
  @ValueSource(strings = {"arena", "platformer"})
  void aRecordingMayBeginInTheMiddleOfTheGame(String game) throws Exception {
    Blocks blocks = new Blocks();
    int begin;
    int end;
    long hash;
    try (Stepper stepper = Stepper.of(game)) {
      List<SimulatedClient> bots = new ArrayList<>();
      for (int i = 0; i < 8; i++) {
        bots.add(stepper.add(bot(i), BAD, new Bot(Stepper.SEED + i)));
      }
      stepper.run(3);
      bots.get(2).leave();
      stepper.run(1);
      begin = stepper.room().simulation().tick();
      stepper.room().record(blocks);
      stepper.run(4);
      end = stepper.room().simulation().tick();
      hash = stepper.room().simulation().stateHash();
    }
    try (RecordingReader reader = RecordingReader.open(blocks.write(folder.resolve("g.carom")))) {
      Replay replay = new Replay(reader);
      playOn(replay);
      assertNull(replay.divergence(), () -> "seed=" + Stepper.SEED + " " + replay.divergence());
      assertEquals(begin, replay.firstTick());
      assertEquals(end, replay.simulation().tick());
      assertEquals(hash, replay.simulation().stateHash());
    }
  }

  /** Three files after each other, of which two are kept; each goes on where the last one ended. */
  @Test
  void filesThatFollowEachOtherAreWholeRecordings() throws Exception {
    List<Path> files = new ArrayList<>();
    long hash;
    try (Stepper stepper = Stepper.of("arena")) {
      RotatingRecording recording =
          new RotatingRecording(
              () -> {
                files.add(folder.resolve("rotated" + files.size() + ".carom"));
                return files.get(files.size() - 1);
              },
              new RotationLimit(2, 0),
              2);
      stepper.room().record(recording);
      for (int i = 0; i < 4; i++) {
        stepper.add(bot(i), BAD, new Bot(Stepper.SEED + i));
      }
      stepper.run(5);
      hash = stepper.room().simulation().stateHash();
      stepper.room().close(GoodbyeReason.SERVER_STOPPING, "", stepper.nowNs());
      recording.close();
    }
    assertTrue(files.size() >= 3, "files=" + files);
    assertFalse(Files.exists(files.get(files.size() - 3)));
    int last = -1;
    long end = 0;
    for (Path file : files.subList(files.size() - 2, files.size())) {
      try (RecordingReader reader = RecordingReader.open(file)) {
        Replay replay = new Replay(reader);
        playOn(replay);
        assertNull(replay.divergence());
        assertTrue(last < 0 || replay.firstTick() == last, "begins at " + replay.firstTick());
        last = replay.simulation().tick();
        end = replay.simulation().stateHash();
      }
    }
    assertEquals(hash, end);
  }

  /** A long duel: jumping to a whole state and playing on comes to where computing all does. */
  @Test
  void aReplayMayBeginAtAnyStateOnTheWay() throws Exception {
    int minute = Recorder.STATE_SECONDS * 60;
    Path file = duel(2 * minute + 100).write(folder.resolve("long.carom"));
    long hash;
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      playOn(replay);
      assertNull(replay.divergence());
      hash = replay.simulation().stateHash();
      assertEquals(minute, replay.stateBefore(2 * minute - 1));
      assertEquals(2 * minute, replay.stateBefore(Integer.MAX_VALUE));
      assertEquals(-1, replay.stateBefore(minute - 1));
      assertTrue(replay.goToStateBefore(minute));
      assertEquals(minute, replay.simulation().tick());
      playOn(replay);
      assertNull(replay.divergence());
      assertEquals(hash, replay.simulation().stateHash());
    }
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      assertFalse(replay.goToStateBefore(5));
      assertTrue(replay.goToStateBefore(2 * minute + 50));
      assertEquals(2 * minute, replay.firstTick());
      playOn(replay);
      assertNull(replay.divergence());
      assertEquals(hash, replay.simulation().stateHash());
    }
  }

  private static SimulationHost start() throws Exception {
    return new SimulationHost(Games.create("arena"), Level.builtIn("arena"), 7, 60, Role.AUTHORITY);
  }

  /** A simulation that two players play, recorded; with no network around it. */
  private static Blocks duel(int ticks) throws Exception {
    Blocks blocks = new Blocks();
    SimulationHost s = start();
    Recorder recorder = new Recorder(s, RecordingHeader.of(s, 7, 99), blocks);
    s.addJournal(recorder);
    HostPlayer one = s.join("one");
    HostPlayer two = s.join("two");
    for (int tick = 1; tick <= ticks; tick++) {
      one.input().move(tick % 90 < 45 ? 0.2f : -0.2f, 0.1f);
      two.input().move(0, tick % 80 < 40 ? 0.2f : -0.2f);
      s.step();
    }
    recorder.end("done");
    return blocks;
  }

  private static void playOn(Replay replay) throws Exception {
    Replay.Progress progress;
    do {
      progress = replay.step();
    } while (progress == Replay.Progress.TICK && !replay.isDecided());
  }

  private Replay replay(Blocks blocks) throws Exception {
    RecordingReader reader = RecordingReader.open(blocks.write(folder.resolve("x.carom")));
    Replay replay = new Replay(reader);
    try (reader) {
      playOn(replay);
    }
    return replay;
  }

  @Test
  void oneFlippedBitOfAnInputIsFoundAtItsTickAndBody() throws Exception {
    Blocks blocks = duel(400);
    assertNull(replay(blocks).divergence());
    long lowestBitOfMoveX = 1L << 16;
    Replay replay = replay(blocks.withInput(217, 1, lowestBitOfMoveX));
    Divergence found = replay.divergence();
    assertNotNull(found);
    assertEquals(217, found.tick());
    assertEquals(217, found.bodyTick());
    assertEquals(1, found.differences().size());
    Divergence.Difference body = found.differences().get(0);
    assertEquals(replay.simulation().player(1).entity().id(), body.id());

    // The recorded state of that body, which the file doesn't hold, is told exactly all the same.
    SimulationHost truth = start();
    HostPlayer one = truth.join("one");
    HostPlayer two = truth.join("two");
    for (int tick = 1; tick <= 217; tick++) {
      one.input().move(tick % 90 < 45 ? 0.2f : -0.2f, 0.1f);
      two.input().move(0, tick % 80 < 40 ? 0.2f : -0.2f);
      truth.step();
    }
    int[] bits = new int[Fingerprint.FIELDS];
    Fingerprint.read(two.entity(), bits);
    assertArrayEquals(new Divergence.Difference(0, "", bits, bits).recorded(), body.recorded());
    assertEquals(truth.stateHash(), found.recordedHash());
  }

  /** Two inputs in two minutes: each spoils its minute, and the whole states between are equal. */
  @Test
  void everyStretchThatDivergedIsFound() throws Exception {
    int minute = Recorder.STATE_SECONDS * 60;
    Blocks whole = duel(3 * minute + 10);
    Blocks changed = whole.withInput(217, 1, 1L << 16).withInput(2 * minute + 5, 1, 1L << 16);
    try (RecordingReader reader = RecordingReader.open(changed.write(folder.resolve("2.carom")))) {
      Replay replay = new Replay(reader);
      Replay.SavedTick before = null;
      while (replay.step() == Replay.Progress.TICK) {
        if (before == null && replay.simulation().tick() > 100 && replay.canMark()) {
          before = replay.mark();
        }
      }
      assertEquals(
          List.of(217, 2 * minute + 5),
          replay.divergences().stream().map(Divergence::tick).toList());
      assertEquals(
          List.of(minute, 3 * minute),
          replay.divergences().stream().map(Divergence::endTick).toList());
      assertEquals(217, replay.divergence().tick());
      assertEquals(216 + minute + 4 + 10, replay.equalTicks());
      replay.reset(before);
      while (replay.step() == Replay.Progress.TICK) {
        // once more the same
      }
      assertEquals(2, replay.divergences().size());
    }
  }

  @Test
  void anInputThatMovesNothingYetIsFoundAtItsTickToo() throws Exception {
    // Nobody reads the highest button in this game: only the hash knows.
    Replay replay = replay(duel(400).withInput(100, 0, 1L << 15));
    assertEquals(100, replay.divergence().tick());
    assertEquals(-1, replay.divergence().bodyTick());
    assertTrue(replay.divergence().toString().contains("no body differs"));
  }

  @Test
  void severalBodiesThatDifferAtOnceAreListedAtTheNextKeyframe() throws Exception {
    long aimAndDash = Input.ACTION;
    Blocks changed = duel(700).withInput(217, 0, 1L << 20).withInput(217, 1, aimAndDash | 1L << 20);
    Divergence found = replay(changed).divergence();
    assertEquals(217, found.tick());
    assertEquals(217, found.bodyTick());
    assertEquals(2, found.differences().size(), found::toString);
    assertTrue(found.toString().contains("several bodies at once, at tick 217"), found::toString);
  }

  @Test
  void aGameThatIsSetUpDifferentlyDivergesAtTickZero() throws Exception {
    Blocks blocks = duel(10);
    RecordingHeader h = RecordingHeader.of(start(), 8, 99); // another seed
    ByteSink header = new ByteSink();
    h.write(header);
    blocks.blocks.set(
        0, new Blocks.Raw(Block.HEADER, Arrays.copyOf(header.array(), header.length())));
    Divergence found = replay(blocks).divergence();
    assertEquals(0, found.tick());
    assertEquals(-1, found.bodyTick());
  }

  @Test
  void aSinkThatCannotKeepUpCutsTheRecording() throws Exception {
    Blocks blocks = new Blocks();
    blocks.capacity = 4; // header, keyframe, two seconds
    SimulationHost s = start();
    Recorder recorder = new Recorder(s, RecordingHeader.of(s, 7, 99), blocks);
    s.addJournal(recorder);
    s.join("one");
    for (int tick = 1; tick <= 200; tick++) {
      s.step();
    }
    assertTrue(recorder.isCut());
    blocks.blocks.add(new Blocks.Raw(Block.END, Recorder.cutBlock("too slow")));
    RecordingReader reader = RecordingReader.open(blocks.write(folder.resolve("cut.carom")));
    Replay replay = new Replay(reader);
    try (reader) {
      playOn(replay);
      assertEquals(120, replay.simulation().tick());
      assertNull(replay.divergence());
      assertTrue(reader.isCut());
      assertEquals("too slow", reader.reason());
    }
  }

  @Test
  void theRecordingOfAGameThatKeepsMoreThanItsStateBeginsAtTickZero() throws Exception {
    Scene car = Scenes.get("car");
    SimulationHost s =
        new SimulationHost(
            new SceneGame(car), SceneGame.level(car), 1, car.tickRate(), Role.AUTHORITY);
    s.step();
    IllegalArgumentException e =
        assertThrows(
            IllegalArgumentException.class,
            () -> new Recorder(s, RecordingHeader.of(s, 7, 99), new Blocks()));
    assertTrue(e.getMessage().contains("tick=1"), e.getMessage());
  }

  /** A state whose bytes were changed, checksum and all, is refused or shown to be another. */
  @Test
  void aDamagedStateIsTold() throws Exception {
    SimulationHost s = start();
    s.join("one").input().move(1, 0);
    for (int i = 0; i < 50; i++) {
      s.step();
    }
    Blocks blocks = new Blocks();
    Recorder recorder = new Recorder(s, RecordingHeader.of(s, 7, 99), blocks);
    s.addJournal(recorder);
    s.step();
    recorder.end("done");
    byte[] good = blocks.blocks.get(1).bytes();
    Random random = new Random(Stepper.SEED);
    int refused = 0;
    for (int round = 0; round < 300; round++) {
      byte[] bad = good.clone();
      int at = random.nextInt(bad.length);
      bad[at] = (byte) (bad[at] ^ 1 << random.nextInt(8));
      blocks.blocks.set(1, new Blocks.Raw(Block.STATE, bad));
      Path file = blocks.write(folder.resolve("bad" + round + ".carom"));
      try (RecordingReader reader = RecordingReader.open(file)) {
        playOn(new Replay(reader));
      } catch (RecordingException e) {
        refused++;
      }
    }
    assertTrue(refused > 50, "refused=" + refused); // many bits are of what could be looked back at
  }
}
