package carom.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.profile.StageListener;
import carom.physics.profile.StepStage;
import carom.sim.scene.SceneRun;
import carom.sim.scene.Scenes;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Who measures a step hears of every part of it, in order, and disturbs nothing. */
final class StageListenerTest {
  private final List<String> heard = new ArrayList<>();
  private final Set<StepStage> stages = EnumSet.noneOf(StepStage.class);

  private final StageListener listener =
      new StageListener() {
        @Override
        public void begins(StepStage stage) {
          heard.add(stage.toString());
          stages.add(stage);
        }

        @Override
        public void done() {
          heard.add("done");
        }
      };

  @Test
  void stepBeginsAndEndsAndPassesThroughEveryStage() {
    SceneRun run = Scenes.get("pile_2k").start();
    run.world().stageListener(listener);
    run.steps(2);
    assertEquals(EnumSet.allOf(StepStage.class), stages);
    assertEquals("begin", heard.get(0));
    assertEquals("done", heard.get(heard.size() - 1));
    assertEquals(2, heard.stream().filter("done"::equals).count());
    assertEquals(2, heard.stream().filter("begin"::equals).count());
    assertTrue(heard.indexOf("pairs") < heard.indexOf("collide"), heard.toString());
    assertTrue(heard.indexOf("collide") < heard.indexOf("prepare"), heard.toString());
    assertEquals(2L * run.world().def().substeps(), count("solve"));
    assertEquals(count("solve"), count("relax"));
  }

  private long count(String stage) {
    return heard.stream().filter(stage::equals).count();
  }

  @Test
  void listeningChangesNoBit() {
    SceneRun watched = Scenes.get("pile_2k").start();
    SceneRun alone = Scenes.get("pile_2k").start();
    watched.world().stageListener(listener);
    watched.steps(30);
    alone.steps(30);
    assertEquals(alone.stateHash(), watched.stateHash());
    watched.world().stageListener(null);
    int before = heard.size();
    watched.step();
    assertEquals(before, heard.size());
  }
}
