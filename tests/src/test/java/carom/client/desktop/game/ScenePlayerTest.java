package carom.client.desktop.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.sim.scene.Scene;
import carom.sim.scene.Scenes;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The viewer's clock and hand, without a window. */
final class ScenePlayerTest {
  private long now;
  private long stepNs;
  private final ScenePlayer player = new ScenePlayer(() -> now += stepNs);

  @BeforeEach
  void open() {
    player.open(Scenes.get("pyramid"));
  }

  @Test
  void framesOfAnyLengthMakeStepsOfOneLength() {
    for (int i = 0; i < 30; i++) {
      player.advance(1 / 144.0);
    }
    assertEquals(12, player.run().tick());
    player.speedUp(-1);
    player.advance(4.1 / 60);
    assertEquals(14, player.run().tick());
  }

  @Test
  void aPausedSceneStandsStillAndStepsOneTickAtATime() {
    player.pause(true);
    player.advance(1);
    assertEquals(0, player.run().tick());
    player.single();
    assertEquals(1, player.run().tick());
    assertTrue(player.paused());
    player.advance(1);
    assertEquals(1, player.run().tick());
  }

  @Test
  void aStalledWindowDoesNotJump() {
    player.advance(60);
    assertTrue(player.run().tick() <= 6, "tick=" + player.run().tick());
  }

  @Test
  void aSceneThatIsTooSlowRunsInSlowMotion() {
    stepNs = 40_000_000;
    for (int i = 0; i < 5; i++) {
      player.advance(0.1);
    }
    assertEquals(5, player.run().tick());
  }

  @Test
  void aBodyUnderTheMouseIsHeldMovedAndFlung() {
    assertFalse(player.grab(0, -0.5f), "the floor is not dynamic");
    assertTrue(player.grab(0.1f, 19.6f));
    Body<String> top = player.held();
    float before = top.y();
    player.drag(0.1f, 25);
    for (int i = 0; i < 20; i++) {
      player.single();
    }
    assertTrue(top.y() > before + 1, "y=" + top.y());
    player.drag(0.1f, 35);
    for (int i = 0; i < 3; i++) {
      player.single();
    }
    player.release();
    assertNull(player.held());
    assertTrue(top.velocityY() > 1, "it keeps its speed: " + top.velocityY());
    assertEquals(0, player.run().world().jointCount());
  }

  @Test
  void aRestartIsTheSameAgain() {
    for (int i = 0; i < 10; i++) {
      player.single();
    }
    long hash = player.run().world().stateHash();
    player.restart();
    assertEquals(0, player.run().tick());
    assertNotEquals(hash, player.run().world().stateHash());
    for (int i = 0; i < 10; i++) {
      player.single();
    }
    assertEquals(hash, player.run().world().stateHash());
  }

  @Test
  void scenesAreTurnedLikePages() {
    Scene first = player.scene();
    player.turn(1);
    assertNotEquals(first.name(), player.scene().name());
    player.turn(-1);
    assertSame(first, player.scene());
  }
}
