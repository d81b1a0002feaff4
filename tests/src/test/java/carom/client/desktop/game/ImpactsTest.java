package carom.client.desktop.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.level.Archetype;
import carom.sim.level.Level;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Goal: hits show, and nothing else does. Method: velocities as frames would show them. */
final class ImpactsTest {
  private static final float FRAME = 1 / 60f;

  private final Impacts impacts = new Impacts((id, kind, x, y, nx, ny, blow) -> false);
  private Archetype ball;
  private Archetype player;
  private int instance = 1;

  @BeforeEach
  void findKinds() throws Exception {
    SimulationHost s =
        new SimulationHost(Games.create("arena"), Level.builtIn("arena"), 0, 60, Role.PREDICTION);
    ball = s.archetypes().find("ball");
    player = s.archetypes().find("player.Red");
  }

  private void frame(Archetype kind, float vx, float vy) {
    impacts.age(0, 0, FRAME);
    impacts.watch(7, instance, kind, 1, 2, vx, vy, FRAME);
  }

  private void frames(Archetype kind, int count, float vx, float vy) {
    for (int i = 0; i < count; i++) {
      frame(kind, vx, vy);
    }
  }

  @Test
  void aBallThatBouncesShowsOnceAndThenFades() {
    frames(ball, 5, 12, 0);
    frames(ball, 3, -9, 0);
    assertEquals(1, impacts.showing());
    assertTrue(impacts.glow(1.7f, 2, 0.1f) > 0.5f, "it came from the left, so it hit on the right");
    assertEquals(0, impacts.glow(-3, 2, 0.5f), "far from it");
    frames(ball, 40, -9, 0);
    assertEquals(0, impacts.showing());
  }

  @Test
  void aBlowThatTakesSeveralFramesIsOne() {
    frames(ball, 5, 12, 0);
    frame(ball, 6, 0);
    frame(ball, -1, 0);
    frames(ball, 5, -9, 0);
    assertEquals(1, impacts.showing());
  }

  @Test
  void fallingAndRollingOutShowNothing() {
    for (int i = 0; i < 60; i++) {
      frame(ball, 5 - i * 0.05f, -26 * i * FRAME);
    }
    assertEquals(0, impacts.showing());
  }

  @Test
  void steeringJumpsAndDashesShowNothingButLandingDoes() {
    frames(player, 5, 8, 0);
    frames(player, 5, 8, 13); // a jump
    frames(player, 5, 17, 13); // a dash
    for (int i = 0; i <= 10; i++) {
      frame(player, 17 - i * 2.5f, 13 - i * 1.3f); // turning round
    }
    assertEquals(0, impacts.showing());
    frames(player, 5, -8, -16);
    frames(player, 3, -8, 0);
    assertEquals(1, impacts.showing());
  }

  @Test
  void aNewEntityInTheSameSlotStartsAfresh() {
    frames(ball, 5, 12, 0);
    instance++;
    frames(ball, 5, -12, 0);
    assertEquals(0, impacts.showing());
  }
}
