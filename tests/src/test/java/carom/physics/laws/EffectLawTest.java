package carom.physics.laws;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.effects.Hover;
import carom.physics.effects.Spring;
import carom.physics.geometry.Box;
import org.junit.jupiter.api.Test;

/** The force laws of effects gain no energy at the default settings. */
class EffectLawTest {
  private static final float DT = 1 / 60f;

  private static Body<String> box(World<String> w, float x, float y) {
    BodyDef def = new BodyDef(BodyType.DYNAMIC).position(x, y);
    return w.createBody(def.shape(new Box(0.5f, 0.5f)), "box");
  }

  @Test
  void springsOfEffectsKeepOrLoseEnergy() {
    for (float ratio : new float[] {0, 0.3f, 1}) {
      for (float hertz : new float[] {0.5f, 2, 1000}) {
        World<String> w = new World<>(new WorldDef().withGravity(0, 0));
        Body<String> b = box(w, 1, 0);
        Spring spring = new Spring(0, 0, 10).hertz(hertz).dampingRatio(ratio);
        double most = 0;
        for (int i = 0; i < 3600; i++) {
          spring.apply(w, DT);
          w.step(DT);
          most = i > 3300 ? Math.max(most, Math.hypot(b.x(), b.y())) : most;
        }
        double bound = ratio > 0 ? 0.02 : hertz < 10 ? 1.01 : 1.2; // slow bodies fall asleep
        assertTrue(most <= bound, "ratio=" + ratio + " hertz=" + hertz + " most=" + most);
      }
    }
  }

  @Test
  void aHoverSettlesAtItsHeight() {
    for (float from : new float[] {1, 2, 5}) {
      World<String> w = new World<>(new WorldDef());
      w.createBody(new BodyDef().position(0, -1).shape(new Box(50, 1)), "floor");
      Body<String> b = box(w, 0, from);
      b.setSleepAllowed(false);
      Hover<String> hover = new Hover<>(1.5f);
      for (int i = 0; i < 900; i++) {
        hover.apply(w, b, DT);
        w.step(DT);
      }
      assertEquals(1.5, b.y(), 0.01);
      assertEquals(0, b.velocityY(), 0.01);
    }
  }
}
