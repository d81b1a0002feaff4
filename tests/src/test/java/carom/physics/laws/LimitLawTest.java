package carom.physics.laws;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.math.Trig;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Every angle limit of a hinge within two turns stops every motor that works against it. */
class LimitLawTest {
  private static final float[] EDGES = {
    Trig.PI, -Trig.PI, 3.1f, -3.1f, 3.14f, 2 * Trig.PI, -2 * Trig.PI, 1.5f, 1.6f
  };

  private final long seed = new Random().nextLong();
  private final Random random = new Random(seed);

  @Test
  void limitsStopAMotor() {
    for (int i = 0; i < 150; i++) {
      float edge = i < EDGES.length ? EDGES[i] : 2 * Trig.PI * (2 * random.nextFloat() - 1);
      float other = random.nextFloat() * (edge > 0 ? -2 : 2);
      float torque = (float) Math.pow(10, 1 + 5 * random.nextFloat()); // N m, on 0.17 kg m^2
      World<String> w = new World<>(new WorldDef().withGravity(0, 0));
      BodyDef def = new BodyDef(BodyType.DYNAMIC).shape(new Box(0.5f, 0.5f));
      Body<String> b = w.createBody(def, "wheel");
      float lower = Math.min(edge, other);
      float upper = Math.max(edge, other);
      JointDef<String> joint = JointDef.revolute(null, b, 0, 0);
      boolean later = random.nextBoolean();
      joint = later ? joint : joint.limits(lower, upper);
      Joint<String> j = w.createJoint(joint.motor(edge > 0 ? 2 : -2, torque));
      if (later) {
        j.setLimits(lower, upper);
      }
      for (int step = 0; step < 400; step++) {
        w.step(1 / 60f);
      }
      String told = "seed=" + seed + " limits=" + lower + ".." + upper + " torque=" + torque;
      assertTrue(Math.abs(j.angle() - edge) < 0.1, () -> told + " angle=" + j.angle());
      assertTrue(Math.abs(b.angularVelocity()) < 0.05, () -> told + " w=" + b.angularVelocity());
    }
  }
}
