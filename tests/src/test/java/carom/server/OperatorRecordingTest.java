package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.Bot;
import carom.net.transport.Impairment;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.server.config.ServerConfig;
import carom.server.recording.RotationLimit;
import carom.sim.scene.SceneGame;
import carom.sim.scene.Scenes;
import carom.testkit.Stepper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: an operator records a game that goes on. Method: what the commands of an operator call,
 * beside a room with bots that is stepped meanwhile.
 */
final class OperatorRecordingTest {
  @TempDir private Path folder;

  private static Stepper busy(String game) {
    Stepper stepper = Stepper.of(game);
    stepper.join("bot", Impairment.NONE.withLoss(5), new Bot(Stepper.SEED));
    stepper.run(1);
    return stepper;
  }

  private static String record(Stepper stepper, Path target) {
    return ask(stepper, () -> stepper.room().operator().record(target));
  }

  private static String stop(Stepper stepper) {
    return ask(stepper, () -> stepper.room().operator().stopRecording());
  }

  private static String ask(Stepper stepper, Supplier<String> question) {
    CompletableFuture<String> answer = CompletableFuture.supplyAsync(question);
    while (!answer.isDone()) {
      stepper.run(0.02);
      Thread.onSpinWait();
    }
    return answer.join();
  }

  /** Plays the whole file; returns the last tick. */
  private static int play(Path file, int first) throws IOException {
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      Replay.Progress progress;
      do {
        progress = replay.step();
        assertNull(replay.divergence());
      } while (progress == Replay.Progress.TICK);
      assertEquals(Replay.Progress.END, progress);
      assertEquals("STOPPED", reader.reason());
      assertEquals(first, replay.firstTick());
      return replay.simulation().tick();
    }
  }

  private static int number(String answer, String name) {
    return Integer.parseInt(answer.replaceAll("(?s).*" + name + "=(\\d+).*", "$1"));
  }

  @Test
  void aRunningGameIsRecordedFromAndUpToAnyTick() throws Exception {
    try (Stepper stepper = busy("arena")) {
      Path file = folder.resolve("middle.carom");
      String begun = record(stepper, file);
      assertTrue(begun.startsWith("recording to " + file), begun);
      stepper.join("later", Impairment.NONE, new Bot(Stepper.SEED + 1));
      String twice = record(stepper, folder.resolve("second.carom"));
      assertTrue(twice.contains("recorded already to " + file), twice);
      assertFalse(Files.exists(folder.resolve("second.carom")));
      stepper.run(2);
      String ended = stop(stepper);
      int first = number(begun, "tick");
      int last = number(ended, "tick");
      assertTrue(first > 30 && last > first + 120, begun + "; " + ended);
      assertEquals(last, play(file, first));
      assertEquals("not recorded", stop(stepper));

      String again = record(stepper, folder);
      assertTrue(again.contains(folder.resolve("arena-").toString()), again);
      stepper.run(0.5);
      stop(stepper);
      Path named = Path.of(again.replaceAll("recording to (.*) from tick=.*", "$1"));
      play(named, number(again, "tick"));
    }
  }

  @Test
  void anOperatorRecordsBesideWhatSpectatorsWatch() throws Exception {
    try (Stepper stepper = Stepper.of("arena")) {
      stepper.server().record(folder.resolve("shown.carom"));
      stepper.server().allowSpectators(1);
      stepper.join("bot", Impairment.NONE, new Bot(Stepper.SEED));
      stepper.run(1);
      assertTrue(stop(stepper).startsWith("spectators watch this recording"));
      Path file = folder.resolve("kept.carom");
      String begun = record(stepper, file);
      assertTrue(begun.startsWith("recording to " + file), begun);
      assertTrue(record(stepper, folder).contains("recorded already to " + file));
      stepper.run(1);
      String ended = stop(stepper);
      assertEquals(number(ended, "tick"), play(file, number(begun, "tick")));
      assertTrue(stop(stepper).startsWith("spectators watch this recording"));
    }
  }

  @Test
  void whatTheServerBeganAnOperatorEnds() throws Exception {
    try (Stepper stepper = Stepper.of("arena")) {
      Path file = stepper.server().record(folder.resolve("all.carom")).get(0);
      stepper.run(1);
      String ended = stop(stepper);
      assertTrue(ended.startsWith("recorded to " + file), ended);
      assertEquals(number(ended, "tick"), play(file, 0));
    }
  }

  @Test
  void filesThatFollowEachOtherAnOperatorEndsToo() throws Exception {
    try (Stepper stepper = Stepper.of("arena")) {
      stepper.server().recordRotating(folder, new RotationLimit(3_600, 0), 0);
      stepper.run(1);
      String ended = stop(stepper);
      Path file = Path.of(ended.replaceAll("recorded to (.*) up to tick=.*", "$1"));
      assertEquals(number(ended, "tick"), play(file, 0));
    }
  }

  @Test
  void theLastWordIsWrittenWhenTheServerStops() throws Exception {
    Path file = folder.resolve("rest.carom");
    try (Stepper stepper = busy("platformer")) {
      record(stepper, file);
      stepper.run(1);
    }
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      while (replay.step() == Replay.Progress.TICK) {}
      assertEquals("SERVER_STOPPING", reader.reason());
    }
  }

  @Test
  void errorsSayWhatIsWrongAndTheGameGoesOn() throws Exception {
    try (Stepper stepper = busy("arena")) {
      Path there = Files.writeString(folder.resolve("there.carom"), "precious");
      String exists = record(stepper, there);
      assertTrue(exists.contains("file=" + there + " exists"), exists);
      assertEquals("precious", Files.readString(there));
      Path lost = folder.resolve("no").resolve("x.carom");
      String missing = record(stepper, lost);
      assertTrue(missing.contains("there is no folder " + lost.getParent()), missing);
      String through = record(stepper, there.resolve("x.carom"));
      assertTrue(through.contains("can't be created"), through);
      assertEquals("not recorded", stop(stepper));
      int tick = stepper.room().tick();
      stepper.run(0.5);
      assertTrue(stepper.room().tick() > tick);
    }
    try (Stepper stepper =
        Stepper.of(SceneGame.level(Scenes.get("car")), ServerConfig.defaults())) {
      stepper.run(0.1);
      String more = record(stepper, folder.resolve("scene.carom"));
      assertTrue(more.contains("keeps more than its state"), more);
      assertFalse(Files.exists(folder.resolve("scene.carom")));
    }
  }
}
