package carom.client.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.app.ClientMain;
import carom.client.bots.Bot;
import carom.client.link.ConnectionPhase;
import carom.client.view.ClientView;
import carom.net.transport.Impairment;
import carom.replay.RecordingException;
import carom.testkit.Stepper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a recording plays, pauses, steps, jumps back and forth, and always shows the recorded game.
 * Method: a recorded match of bots, in virtual time; the hashes in the file are the oracle.
 */
final class ReplayClientTest {
  private static final long TICK_NS = 1_000_000_000L / 60 + 1;

  @TempDir private static Path folder;
  private static Path recorded;
  private long nowNs = 1;

  @BeforeEach
  void record() throws IOException {
    if (recorded == null) {
      try (Stepper stepper = Stepper.of("arena")) {
        recorded = stepper.server().record(folder.resolve("match.carom")).get(0);
        for (int i = 0; i < 3; i++) {
          stepper.join("bot" + i, Impairment.NONE, new Bot(i));
        }
        stepper.run(14);
      }
    }
  }

  private void run(ReplayClient client, int frames) {
    for (int i = 0; i < frames; i++) {
      nowNs += TICK_NS;
      client.update(nowNs);
      assertEquals("", client.problem());
      assertNull(client.divergence());
    }
  }

  private void settle(ReplayClient client) {
    for (int i = 0; i < 10_000 && client.seeking(); i++) {
      run(client, 1);
    }
    assertFalse(client.seeking());
  }

  @Test
  void playsPausesStepsAndChangesItsSpeed() throws Exception {
    try (ReplayClient client = new ReplayClient(recorded)) {
      client.update(nowNs);
      run(client, 120);
      assertEquals(120, client.tick(), 1);
      assertEquals(ConnectionPhase.PLAYING, client.view().phase());
      assertEquals("arena", client.view().game());
      client.pause(true);
      int stopped = client.tick();
      run(client, 30);
      assertEquals(stopped, client.tick());
      client.single();
      assertEquals(stopped + 1, client.tick());
      client.speedUp(2);
      assertEquals(4, client.speed());
      client.pause(false);
      run(client, 30);
      assertTrue(client.tick() > stopped + 40, "tick=" + client.tick());
      client.speedUp(-100);
      assertEquals(1 / 16.0, client.speed());
    }
  }

  @Test
  void whatIsSkippedIsNoNews() throws Exception {
    Path goals;
    try (Stepper stepper = Stepper.of("arena")) {
      goals = stepper.server().record(folder.resolve("goals.carom")).get(0);
      for (int i = 0; i < 4; i++) {
        stepper.join("bot" + i, Impairment.NONE, new Bot(i));
      }
      stepper.run(60);
    }
    try (ReplayClient played = new ReplayClient(goals);
        ReplayClient skipped = new ReplayClient(goals)) {
      int ticks = played.lastTick();
      played.update(nowNs);
      run(played, ticks - 5);
      assertFalse(played.view().notices().isEmpty(), "the recording has a notice");
      skipped.seek(ticks - 5);
      settle(skipped);
      run(skipped, 3);
      assertTrue(skipped.view().notices().isEmpty());
    }
  }

  @Test
  void jumpsShowTheSameGameAsPlayingThrough() throws Exception {
    long[] hashes = new long[700];
    try (ReplayClient client = new ReplayClient(recorded)) {
      int last = client.lastTick();
      client.pause(true);
      for (int tick = 1; tick < hashes.length; tick++) {
        client.single();
        hashes[client.tick()] = client.simulation().stateHash();
      }
      for (int tick : new int[] {350, 349, 650, 0, 10, 699, 301, 300, 299, 5}) {
        client.seek(tick);
        settle(client);
        assertEquals(tick, client.tick());
        if (tick > 0) {
          assertEquals(hashes[tick], client.simulation().stateHash(), "tick=" + tick);
        }
      }
      assertTrue(client.lastTick() >= 699);
      client.seek(Integer.MAX_VALUE);
      settle(client);
      assertTrue(client.ended());
      assertEquals(client.tick(), last, "the end was known from the beginning");
      client.seek(100);
      settle(client);
      assertEquals(hashes[100], client.simulation().stateHash());
      assertFalse(client.ended());
    }
  }

  @Test
  void showsEveryBodyWhereItIsAndFollowsPlayers() throws Exception {
    try (ReplayClient client = new ReplayClient(recorded)) {
      client.pause(true);
      client.seek(500);
      settle(client);
      ClientView view = client.view();
      assertEquals(client.simulation().entityCount(), view.entityCount());
      for (int i = 0; i < view.entityCount(); i++) {
        ClientView.Drawn drawn = view.entity(i);
        assertEquals(client.simulation().entity(drawn.id()).body().x(), drawn.x());
        assertEquals(client.simulation().entity(drawn.id()).archetype(), drawn.archetype());
      }
      assertEquals(3, view.players().size());
      assertNull(view.own());
      client.followNext();
      client.update(nowNs += TICK_NS);
      assertNotNull(view.own());
      assertEquals("bot0", client.followed());
      for (int i = 0; i < 3; i++) {
        client.followNext();
      }
      client.update(nowNs += TICK_NS);
      assertNull(view.own());
    }
  }

  @Test
  void waitsAtTheEndOfAFileThatGrowsAndGoesOn() throws Exception {
    byte[] all = Files.readAllBytes(recorded);
    Path file = folder.resolve("growing.carom");
    Files.write(file, Arrays.copyOf(all, all.length / 2));
    try (ReplayClient client = new ReplayClient(file)) {
      client.seek(Integer.MAX_VALUE);
      settle(client);
      assertTrue(client.waiting());
      int before = client.tick();
      Files.write(file, all);
      run(client, 30);
      assertFalse(client.waiting());
      assertTrue(client.tick() > before && client.tick() <= before + 32);
    }
  }

  @Test
  void whatIsNoRecordingIsRefusedInWords() throws Exception {
    Path noise = Files.write(folder.resolve("noise"), new byte[100]);
    assertThrows(RecordingException.class, () -> new ReplayClient(noise));
    assertEquals(2, ClientMain.run("--replay", noise.toString()));
    assertEquals(2, ClientMain.run("--replay", recorded.toString(), "--headless"));
  }
}
