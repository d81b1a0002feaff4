package carom.sim.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.sim.Role;
import carom.sim.SimulationHost;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** A scene that players watch is the scene. */
final class SceneGameTest {
  static Stream<Scene> scenes() {
    return ScenesTest.scenes().filter(SceneGameTest::listed);
  }

  private static boolean listed(Scene scene) {
    return Scenes.names().contains(scene.name()) && Scenes.get(scene.name()).equals(scene);
  }

  private static SimulationHost simulation(Scene scene, Role role) {
    return new SimulationHost(
        new SceneGame(scene), SceneGame.level(scene), 1, scene.tickRate(), role);
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void theServersWorldIsTheScenesBitForBitAndAllOfItIsSeen(Scene scene) {
    SimulationHost server = simulation(scene, Role.AUTHORITY);
    SimulationHost client = simulation(scene, Role.PREDICTION);
    SceneRun run = scene.with(scene.def().withSleeping(true).withContinuous(true)).start();
    for (int i = 0; i < 130; i++) {
      server.step();
      run.step();
    }
    assertEquals(run.world().stateHash(), server.world().stateHash(), scene.name());
    assertEquals(run.world().bodyCount(), server.entityCount(), scene.name());
    assertEquals(server.archetypes().size(), client.archetypes().size());
    for (int i = 0; i < server.archetypes().size(); i++) {
      assertEquals(
          server.archetypes().get(i).appearance(), client.archetypes().get(i).appearance());
    }
  }

  @Test
  void bodiesThatASceneTakesAwayAreNoEntitiesAnyMore() {
    SimulationHost server = simulation(Scenes.get("conveyor"), Role.AUTHORITY);
    int most = 0;
    for (int i = 0; i < 2400; i++) {
      server.step();
      most = Math.max(most, server.entityCount());
      assertEquals(server.world().bodyCount(), server.entityCount(), "tick " + i);
    }
    assertTrue(server.entityCapacity() < 2400 / 40, "some fell and went: most=" + most);
  }

  @Test
  void aSceneIsFoundAsAGame() {
    assertEquals("scene:car", Games.create("scene:car").name());
    assertEquals(Scenes.get("car").description(), Games.create("scene:car").description());
  }
}
