package carom.physics;

import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.settings.MixingRule;
import org.junit.jupiter.api.Test;

/** What a program sets for contacts is a call like any other: recorded, and replayed to the bit. */
final class ContactRecordingTest {
  @Test
  void overridesMixingRulesAndRefiltersAreReplayed() {
    World<String> w = Scenes.pile(40, 8, new WorldDef().withFrictionMixing(MixingRule.MIN));
    WorldRecorder recorder = new WorldRecorder(w, 1 << 22, 1);
    int[] set = {0};
    w.listener(
        new CollisionListener<>() {
          @Override
          public boolean preSolve(Collision<String> c) {
            if ((c.self().index() + c.other().index()) % 3 == 0) {
              c.setFriction(0);
              c.setRestitution(.5f);
              c.setTangentSpeed(1);
              set[0]++;
            }
            return c.other().index() % 7 > 0;
          }
        });
    steps(w, 60);
    w.body(5).refilter();
    w.body(6).setMaterial(0, Material.DEFAULT.withRestitutionMixing(MixingRule.MULTIPLY));
    steps(w, 60);
    assertTrue(set[0] > 100, "set=" + set[0]);
    WorldReplay replay = new WorldReplay(recorder.finish());
    assertNull(replay.run());
    assertEquals(120, replay.steps());
    assertEquals(w.stateHash(), replay.world().stateHash());
  }
}
