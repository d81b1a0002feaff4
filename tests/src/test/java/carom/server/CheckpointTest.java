package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.CrouchGame;
import carom.fixtures.CrouchGame.Rule;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.replay.RecordingReader;
import carom.server.checkpoint.RoomCheckpoints;
import carom.server.checkpoint.SlotDisk;
import carom.server.match.HandedInMatch;
import carom.server.match.MatchLibrary;
import carom.server.metrics.Counter;
import carom.server.session.LoadedLevel;
import carom.server.session.Session;
import carom.sim.Game;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.level.LevelException;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.MessageKind.Direction;
import carom.sim.message.PlayerColour;
import carom.sim.outbox.NextMatch;
import carom.suite.Needs;
import carom.testkit.Folders;
import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.slf4j.LoggerFactory;

/**
 * Goal: a server that was killed goes on as if it had not been. Method: in virtual time; a crash is
 * a copy of the folder at some moment, from which another server begins.
 */
@Needs("waits")
@Timeout(120)
class CheckpointTest {
  private static final long START_NS = 1_000_000_000L;

  @TempDir Path folder;
  private int copies;

  private Path crash() throws Exception {
    Path kept = folder.resolve("kept" + copies);
    copies++;
    return Folders.copy(kept, folder.resolve("kept" + copies));
  }

  /** Plays for a second and leaves two bodies behind, whose players have lost their links. */
  private static void play(KeptServer kept, long seed) {
    Random random = new Random(seed);
    FakeClient ann = kept.join("Ann", 0);
    FakeClient bob = kept.join("Bob", 0);
    while (kept.tick() < 90) {
      ann.input.move(random.nextInt(3) - 1, random.nextInt(3) - 1);
      bob.input.hold(Input.ACTION, random.nextBoolean());
      kept.step();
    }
    ann.link.close("cut");
    bob.link.close("cut");
    kept.clients.clear();
  }

  @Test
  void aLinkThatIsLostWhileTheProcessStandsStillIsWrittenWithTheWholeGrace() throws Exception {
    try (KeptServer kept =
        new KeptServer(KeptServer.library(), List.of("arena"), folder.resolve("kept0"), START_NS)) {
      kept.join("Ann", 0);
      kept.clients.clear();
      // By the clock after SIGSTOP and SIGCONT, which the last tick's time doesn't know of.
      kept.room().session(0).detach(kept.nowNs + 16_000_000_000L).close("cut");
      int tick = kept.tick();
      for (int i = 0; i < 150; i++) {
        kept.step();
      }
      assertEquals(tick + 150, kept.tick(), "the room goes on");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"arena", "platformer", "commons", "lagoon", "sluice", "chain"})
  void threeCrashesLaterTheWorldIsTheOneWithoutCrashes(String level) throws Exception {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    List<String> levels = List.of(level);
    long expected;
    try (KeptServer without = new KeptServer(KeptServer.library(), levels, null, START_NS)) {
      play(without, seed);
      without.runTo(600);
      expected = without.hash();
    }
    Random random = new Random(seed);
    KeptServer kept =
        new KeptServer(KeptServer.library(), levels, folder.resolve("kept0"), START_NS);
    try {
      play(kept, seed);
      for (int i = 0; i < 3; i++) {
        kept.runTo(kept.tick() + 60 + random.nextInt(80));
        int tick = kept.tick();
        Path crashed = crash();
        kept.close();
        kept = new KeptServer(KeptServer.library(), levels, crashed, START_NS + kept.nowNs);
        assertEquals(1, kept.server.count(Counter.ROOMS_RESUMED), "seed=" + seed);
        int lost = tick - kept.resumedTick;
        assertTrue(lost >= 0 && lost <= 16, "lost=" + lost + " ticks, seed=" + seed);
        for (int id = 0; id < 2; id++) {
          assertEquals(SessionState.GRACE, kept.room().session(id).state());
        }
      }
      kept.runTo(600);
      assertEquals(expected, kept.hash(), "seed=" + seed);
    } finally {
      kept.close();
    }
  }

  @Test
  void theColourThatAPlayerChoseOutlivesTheCrash() throws Exception {
    List<String> levels = List.of("platformer");
    long secret;
    KeptServer kept =
        new KeptServer(KeptServer.library(), levels, folder.resolve("kept0"), START_NS);
    try {
      kept.join("Ann", 0);
      FakeClient bob = kept.join("Bob", 0);
      byte[] colour =
          kept.room()
              .simulation()
              .messageKinds()
              .encode(BuiltInKinds.COLOUR.of(PlayerColour.VIOLET), Direction.FROM_CLIENT);
      bob.link.send(new ClientMessage.GameMessage(1, colour));
      kept.runTo(kept.tick() + 150); // the game, and then a checkpoint, take it
      secret = bob.welcome.sessionSecret();
      Path crashed = crash();
      kept.close();
      kept = new KeptServer(KeptServer.library(), levels, crashed, START_NS + kept.nowNs);
      FakeClient watching = kept.join("Eve", 0);
      kept.runTo(kept.tick() + 30);
      assertEquals(SessionState.GRACE, kept.room().session(1).state());
      assertEquals(PlayerColour.VIOLET, kept.room().session(1).player().colour());
      assertEquals(PlayerColour.OF_THE_GAME, kept.room().session(0).player().colour());
      kept.join("Bob", secret);
      kept.runTo(kept.tick() + 30);
      assertEquals(PlayerColour.VIOLET, kept.room().session(1).player().colour());
      assertEquals(
          PlayerColour.VIOLET.number(),
          watching.messages.stream()
              .filter(ServerMessage.Roster.class::isInstance)
              .flatMap(message -> ((ServerMessage.Roster) message).entries().stream())
              .filter(entry -> entry.playerId() == 1)
              .reduce((before, last) -> last)
              .orElseThrow()
              .colour(),
          "others are told");
    } finally {
      kept.close();
    }
  }

  @Test
  void whatBecameAnotherIsThatAfterTheCrash() throws Exception {
    // Goal: crates that are ice, ghosts or rock, and players who crouch, are so in the resumed
    // room,
    // which goes on as if nothing had happened. Method: as above, and the names of all archetypes.
    MatchLibrary library =
        new HandedInMatch(
            () -> new CrouchGame(Rule.CRATES_CHANGE), CrouchGame.level(Rule.CRATES_CHANGE));
    List<String> levels = List.of("become");
    Map<Integer, String> had = new HashMap<>();
    long expected;
    try (KeptServer without = new KeptServer(library, levels, null, START_NS)) {
      crouch(without, had, 90);
      crouch(without, had, 600);
      expected = without.hash();
    }
    assertTrue(had.values().stream().distinct().count() > 20, "changes");
    KeptServer kept = new KeptServer(library, levels, folder.resolve("kept0"), START_NS);
    try {
      crouch(kept, new HashMap<>(), 90);
      for (int crash = 1; crash <= 3; crash++) {
        kept.runTo(90 + 130 * crash);
        Path crashed = crash();
        kept.close();
        kept = new KeptServer(library, levels, crashed, START_NS + kept.nowNs);
        assertEquals(1, kept.server.count(Counter.ROOMS_RESUMED));
        assertEquals(had.get(kept.resumedTick), kinds(kept), "tick=" + kept.resumedTick);
      }
      kept.runTo(600);
      assertEquals(had.get(600), kinds(kept));
      assertEquals(expected, kept.hash());
    } finally {
      kept.close();
    }
  }

  /** Plays up to a tick and notes the archetypes; until tick 90 with a player who crouches. */
  private static void crouch(KeptServer kept, Map<Integer, String> had, int tick) {
    FakeClient ann = kept.tick() < 90 ? kept.join("Ann", 0) : null;
    while (kept.tick() < tick) {
      if (ann != null) {
        ann.input.hold(Input.ACTION, kept.tick() / 20 % 2 == 0).move(kept.tick() % 3 - 1, 0);
      }
      kept.step();
      had.put(kept.tick(), kinds(kept));
    }
    if (ann != null) {
      ann.link.close("cut");
      kept.clients.clear();
    }
  }

  private static String kinds(KeptServer kept) {
    SimulationHost s = kept.room().simulation();
    StringBuilder kinds = new StringBuilder();
    for (int id = 0; id < s.entityCapacity(); id++) {
      if (s.entity(id) != null) {
        kinds.append(id).append(s.entity(id).archetype().name()).append(' ');
      }
    }
    return kinds.toString();
  }

  @Test
  void aPlayerComesBackToItsBodyTeamAndScoreByItsSecret() throws Exception {
    List<String> levels = List.of("chain");
    KeptServer kept =
        new KeptServer(KeptServer.library(), levels, folder.resolve("kept0"), START_NS);
    FakeClient ann = kept.join("Ann", 0);
    FakeClient bob = kept.join("Bob", 0);
    kept.room().session(1).seat().mute(true);
    bob.input.hold(Input.ACTION, true);
    kept.runTo(200);
    HostPlayer before = kept.room().simulation().player(1);
    int incarnation = bob.welcome.incarnation();
    Path crashed = crash();
    kept.close();
    kept = new KeptServer(KeptServer.library(), levels, crashed, START_NS);
    try {
      int resumedTick = kept.resumedTick;
      kept.runTo(resumedTick + 30);
      FakeClient back = kept.join("Bob", bob.welcome.sessionSecret());
      assertEquals(1, back.welcome.playerId());
      assertEquals(bob.welcome.match(), back.welcome.match());
      assertNotEquals(incarnation, back.welcome.incarnation());
      assertEquals(resumedTick, back.welcome.courseTick());
      HostPlayer player = kept.room().simulation().player(1);
      assertEquals(before.entity().id(), player.entity().id());
      assertEquals(before.entity().generation(), player.entity().generation());
      assertTrue(player.score() > 0 && player.score() <= before.score(), "score");
      Session session = kept.room().session(1);
      assertTrue(session.seat().isMuted());
      assertEquals(SessionState.GRACE, kept.room().session(0).state());
      FakeClient again = kept.join("Ann", ann.welcome.sessionSecret());
      assertEquals(0, again.welcome.playerId());
      assertEquals(2, kept.server.count(Counter.RESUMES));
      assertEquals(2, kept.room().simulation().playerCount());
    } finally {
      kept.close();
    }
  }

  @Test
  void eventsThatAClientHasNotAcknowledgedComeAfterTheCrash() throws Exception {
    List<String> levels = List.of("chain");
    MatchLibrary library = with(game -> game.teamsHide = true);
    KeptServer kept = new KeptServer(library, levels, folder.resolve("kept0"), START_NS);
    FakeClient ann = kept.join("Ann", 0);
    kept.join("Eve", 0);
    FakeClient bob = kept.join("Bob", 0); // Ann's team
    bob.input.hold(Input.ACTION, true);
    kept.runTo(60);
    bob.input.hold(Input.ACTION, false);
    kept.runTo(80);
    int heard = ann.eventsBy.size();
    assertTrue(heard > 5, "heard=" + heard);
    ann.acks = false;
    bob.input.hold(Input.ACTION, true);
    kept.runTo(kept.tick() + 10);
    bob.input.hold(Input.ACTION, false);
    kept.runTo(150);
    kept.runTo(300);
    Path crashed = crash();
    kept.close();
    kept = new KeptServer(library, levels, crashed, START_NS);
    try {
      FakeClient back = kept.join("Ann", ann.welcome.sessionSecret());
      kept.runTo(kept.tick() + 60);
      int repeated = back.eventsBy.size();
      assertTrue(repeated >= 8 && repeated <= 12, "repeated=" + repeated + " of about 10");
    } finally {
      kept.close();
    }
  }

  private static MatchLibrary with(Consumer<TestGame> change) {
    MatchLibrary library = KeptServer.library();
    return new MatchLibrary() {
      @Override
      public Game game(String name) {
        TestGame game = (TestGame) library.game(name);
        change.accept(game);
        return game;
      }

      @Override
      public LoadedLevel level(String name) throws LevelException {
        return library.level(name);
      }
    };
  }

  @Test
  void theRotationGoesOnWhereItWasAndARequestedMatchIsNotForgotten() throws Exception {
    List<String> levels = List.of("arena", "platformer", "commons");
    KeptServer kept =
        new KeptServer(MatchLibrary.INSTALLED, levels, folder.resolve("kept0"), START_NS);
    kept.runTo(30);
    kept.room().simulation().matchOver();
    kept.step();
    kept.runTo(70);
    assertEquals("platformer", kept.room().match().game());
    Path crashed = crash();
    kept.close();
    kept = new KeptServer(MatchLibrary.INSTALLED, levels, crashed, START_NS);
    assertEquals("platformer", kept.room().match().game());
    assertEquals(2, kept.room().match().number());
    kept.room().simulation().matchOver();
    kept.step();
    kept.step();
    assertEquals("Commons", kept.room().match().level().level().name());
    assertEquals(3, kept.room().match().number());
    kept.room().simulation().playNext(NextMatch.level("no such level"));
    kept.step();
    kept.step();
    assertEquals("Commons", kept.room().match().level().level().name());
    kept.close();
  }

  @Test
  void aServerThatStopsInGoodOrderTakesALastCheckpoint() throws Exception {
    List<String> levels = List.of("chain");
    Path path = folder.resolve("kept0");
    KeptServer kept = new KeptServer(KeptServer.library(), levels, path, START_NS);
    FakeClient ann = kept.join("Ann", 0);
    kept.runTo(77);
    long hash = kept.hash();
    kept.close();
    kept = new KeptServer(KeptServer.library(), levels, path, START_NS);
    try {
      assertEquals(77, kept.resumedTick);
      assertEquals(hash, kept.resumedHash);
      assertEquals(1, kept.server.count(Counter.ROOMS_RESUMED));
      FakeClient back = kept.join("Ann", ann.welcome.sessionSecret());
      assertEquals(0, back.welcome.playerId());
    } finally {
      kept.close();
    }
  }

  @Test
  void aDiskThatTakesNothingIsToldOnceAndAlsoWhenItDoesAgain() throws Exception {
    Logger logger = (Logger) LoggerFactory.getLogger(RoomCheckpoints.class);
    ListAppender<ILoggingEvent> log = new ListAppender<>();
    log.start();
    logger.addAppender(log);
    logger.setLevel(Level.INFO);
    Path path = folder.resolve("kept0");
    KeptServer kept = new KeptServer(KeptServer.library(), List.of("chain"), path, START_NS);
    try {
      kept.runTo(100);
      Path files;
      try (Stream<Path> all = Files.list(path)) {
        files = all.filter(Files::isDirectory).findFirst().orElseThrow();
      }
      Path away = Files.move(files, folder.resolve("away"));
      stepUntil(kept, () -> kept.server.count(Counter.CHECKPOINTS_FAILED) >= 3);
      assertEquals(1, lines(log, "another one is tried each second"));
      Files.move(away, files);
      stepUntil(kept, () -> lines(log, "the disk takes checkpoints again") > 0);
      assertEquals(1, lines(log, "another one is tried each second"));
      assertEquals(1, lines(log, "the disk takes checkpoints again"));
    } finally {
      logger.setLevel(null);
      logger.detachAppender(log);
      kept.close();
    }
  }

  private static long lines(ListAppender<ILoggingEvent> log, String text) {
    return List.copyOf(log.list).stream()
        .filter(line -> line.getFormattedMessage().contains(text))
        .count();
  }

  private static void stepUntil(KeptServer kept, BooleanSupplier what) throws Exception {
    while (!what.getAsBoolean()) {
      kept.step();
      Thread.sleep(1); // the disk has a thread of its own; the test's time limit ends this
    }
  }

  @Test
  void aRoomThatFailsAgainAndAgainBeginsAnewInTheEnd() throws Exception {
    Path path = folder.resolve("kept0");
    List<String> levels = List.of("chain");
    int[] failEvery = {0};
    MatchLibrary library = with(game -> game.failEvery = failEvery[0]);
    KeptServer kept = new KeptServer(library, levels, path, START_NS);
    kept.runTo(100);
    kept.close();
    failEvery[0] = 1;
    for (int run = 0; run < 4; run++) {
      kept = new KeptServer(library, levels, path, START_NS);
      assertEquals(run < 3 ? 1 : 0, kept.server.count(Counter.ROOMS_RESUMED), "run=" + run);
      for (int i = 0; i < 70; i++) {
        kept.step();
      }
      assertTrue(kept.server.hasFailed());
      kept.close();
    }
  }

  @Test
  void anErrorOfTheGameRefusesOneCheckpointAndTheOneBeforeIsUsed() throws Exception {
    Path path = folder.resolve("kept0");
    List<String> levels = List.of("chain");
    KeptServer kept = new KeptServer(KeptServer.library(), levels, path, START_NS);
    kept.runTo(150);
    Path crashed = crash();
    int tick = kept.tick();
    kept.close();
    Error missing = new NoSuchMethodError("of another library");
    for (Error error : List.of(missing, new OutOfMemoryError("on purpose"))) {
      Path copy = Folders.copy(crashed, folder.resolve(error.getClass().getSimpleName()));
      Deque<Error> errors = new ArrayDeque<>(List.of(error));
      MatchLibrary library = with(game -> game.keepsMoreFails = errors::poll);
      kept = new KeptServer(library, levels, copy, START_NS);
      try {
        assertTrue(errors.isEmpty());
        assertEquals(1, kept.server.count(Counter.ROOMS_RESUMED));
        int lost = tick - kept.resumedTick;
        assertTrue(lost > 16 && lost <= 16 + 60, "the slot before: lost=" + lost + " ticks");
      } finally {
        kept.close();
      }
    }
  }

  @Test
  void aPowerFailureThatTakesTheLatestSeatsLosesOnlyWhoCameSince() throws Exception {
    List<String> levels = List.of("chain");
    KeptServer kept =
        new KeptServer(KeptServer.library(), levels, folder.resolve("kept0"), START_NS);
    kept.join("Ann", 0);
    kept.runTo(130);
    kept.join("Bob", 0);
    kept.runTo(170);
    Path crashed = crash();
    kept.close();
    Path room = crashed.resolve("cup");
    List<Path> latest;
    try (Stream<Path> files = Files.list(room)) {
      latest = files.filter(file -> file.toString().endsWith(".latest")).toList();
    }
    assertFalse(latest.isEmpty(), "Bob came behind a checkpoint");
    for (boolean torn : new boolean[] {false, true}) {
      Path copy = Folders.copy(crashed, folder.resolve("torn-" + torn));
      for (Path file : latest) {
        if (torn) { // as a system leaves a new file that it has only named
          Files.write(copy.resolve("cup").resolve(file.getFileName()), new byte[0]);
        }
      }
      try (KeptServer again = new KeptServer(KeptServer.library(), levels, copy, START_NS)) {
        assertEquals(1, again.server.count(Counter.ROOMS_RESUMED), "torn=" + torn);
        assertTrue(again.resumedTick >= 150, "torn=" + torn + ": tick=" + again.resumedTick);
        assertEquals(SessionState.GRACE, again.room().session(0).state());
        assertEquals(torn, again.room().session(1) == null, "Bob's seat, torn=" + torn);
      }
    }
  }

  @Test
  void twoServersDoNotShareAFolder() {
    Path path = folder.resolve("kept0");
    KeptServer kept = new KeptServer(KeptServer.library(), List.of("chain"), path, START_NS);
    try {
      UncheckedIOException refused =
          assertThrows(
              UncheckedIOException.class,
              () -> new KeptServer(KeptServer.library(), List.of("chain"), path, START_NS));
      assertTrue(refused.getMessage().contains("another server uses folder="), "" + refused);
    } finally {
      kept.close();
    }
  }

  @Test
  void aRoomOfOtherSettingsRefusesTheCheckpointAndKeepsTheFiles() throws Exception {
    Path path = folder.resolve("kept0");
    KeptServer kept = new KeptServer(MatchLibrary.INSTALLED, List.of("arena"), path, START_NS);
    kept.runTo(100);
    kept.close();
    kept = new KeptServer(MatchLibrary.INSTALLED, List.of("platformer"), path, START_NS);
    assertEquals("platformer", kept.room().match().game());
    assertEquals(0, kept.server.count(Counter.ROOMS_RESUMED));
    assertEquals(0, kept.resumedTick);
    kept.close();
    try (Stream<Path> files = Files.list(path.resolve("cup"))) {
      assertTrue(files.anyMatch(file -> file.toString().endsWith(".log.refused")));
    }
  }

  @Test
  void anUpdateToOtherPhysicsGoesOnFromTheCheckpointWithoutItsLog() throws Exception {
    List<String> levels = List.of("arena");
    Path path = folder.resolve("kept0");
    int checkpoint;
    int secondsTick;
    try (KeptServer kept = new KeptServer(KeptServer.library(), levels, path, START_NS)) {
      play(kept, 3);
      kept.runTo(150);
      secondsTick = kept.tick();
      Path crashed = crash();
      checkpoint = otherPhysics(crashed.resolve("cup"));
    }
    Path crashed = folder.resolve("kept" + copies);
    try (KeptServer kept = new KeptServer(KeptServer.library(), levels, crashed, START_NS)) {
      assertEquals(1, kept.server.count(Counter.ROOMS_RESUMED));
      assertTrue(kept.resumedTick > 0 && kept.resumedTick < secondsTick, "" + kept.resumedTick);
      assertEquals(checkpoint, kept.resumedTick, "the checkpoint, not a tick of the log");
      for (int id = 0; id < 2; id++) {
        assertEquals(SessionState.GRACE, kept.room().session(id).state());
      }
      kept.runTo(kept.tick() + 60);
    }
  }

  /**
   * Makes slots look as if a build with other physics had kept them.
   *
   * @return the tick of the newest checkpoint
   */
  private static int otherPhysics(Path room) throws IOException {
    int newest = -1;
    try (Stream<Path> files = Files.list(room)) {
      for (Path file : files.filter(f -> f.toString().endsWith(".seats")).toList()) {
        byte[] bytes = Files.readAllBytes(file);
        bytes[20]++; // the digest follows magic, format and checksum
        CRC32 sum = new CRC32();
        sum.update(bytes, 20, bytes.length - 20);
        ByteBuffer.wrap(bytes).putLong(12, sum.getValue());
        Files.write(file, bytes);
        Path log = Path.of(file.toString().replace(".seats", ".log"));
        try (RecordingReader reader = RecordingReader.open(log)) {
          assertEquals(RecordingReader.Entry.STATE, reader.next());
          newest = Math.max(newest, reader.stateTick());
        }
      }
    }
    return newest;
  }

  @Test
  void onlyTheOwnerMayReadSlots() throws Exception {
    Path path = folder.resolve("kept0");
    KeptServer kept = new KeptServer(KeptServer.library(), List.of("chain"), path, START_NS);
    kept.runTo(200);
    kept.close();
    int logs = 0;
    try (Stream<Path> files = Files.list(path.resolve("cup"))) {
      for (Path file : files.toList()) {
        assertEquals(
            "rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
        logs += file.toString().endsWith(".log") ? 1 : 0;
      }
    }
    assertEquals(2, logs, "the last two slots");
  }

  @Test
  void aGameThatKeepsMoreThanItsStateIsNotKept() throws Exception {
    Path path = folder.resolve("kept0");
    List<String> levels = List.of("chain");
    KeptServer kept = new KeptServer(with(game -> game.keepsMore = true), levels, path, START_NS);
    kept.runTo(200);
    assertEquals(0, kept.server.count(Counter.CHECKPOINTS));
    kept.close();
    try (Stream<Path> files = Files.list(path.resolve("cup"))) {
      assertFalse(files.anyMatch(file -> file.toString().endsWith(".log")));
    }
  }

  @Test
  void aStateAboveTheLimitIsRefusedByNameAndTheRoomGoesOn() throws Exception {
    Path path = folder.resolve("big");
    Logger log = (Logger) LoggerFactory.getLogger(RoomCheckpoints.class);
    ListAppender<ILoggingEvent> lines = new ListAppender<>();
    lines.start();
    log.addAppender(lines);
    try (SlotDisk disk = new SlotDisk(1_000);
        KeptServer kept = new KeptServer(KeptServer.library(), List.of("chain"), null, START_NS)) {
      kept.room().checkpoint(disk, path, 1);
      kept.runTo(200);
      assertEquals(0, kept.server.count(Counter.CHECKPOINTS));
      assertEquals(4, kept.server.count(Counter.CHECKPOINTS_FAILED), "one is tried each second");
    } finally {
      log.detachAppender(lines);
    }
    List<String> texts = lines.list.stream().map(ILoggingEvent::getFormattedMessage).toList();
    assertEquals(1, texts.size(), () -> "told once: " + texts);
    assertTrue(
        texts.get(0).matches(".*no checkpoint of game=test level=chain: .* are more than 1000, .*"),
        () -> texts.get(0));
    try (Stream<Path> files = Files.list(path)) {
      assertEquals(List.of(), files.filter(file -> file.toString().endsWith(".log")).toList());
    }
  }

  @Test
  void aFolderThatCanNotBeUsedStopsTheStart() throws IOException {
    Path file = Files.writeString(folder.resolve("file"), "");
    assertThrows(
        UncheckedIOException.class,
        () -> new KeptServer(KeptServer.library(), List.of("chain"), file, START_NS));
  }
}
