package carom.physics.laws;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.effects.Explosion;
import carom.physics.effects.Wind;
import carom.physics.geometry.Box;
import carom.physics.geometry.Polygon;
import carom.physics.math.Aabb;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** How a body is cut into shapes, and how thin a shape is, makes no difference. */
class CutLawTest {
  private final long seed = new Random().nextLong();
  private final Random random = new Random(seed);

  private static Body<String> cut(World<String> w, int columns, int rows) {
    BodyDef def = new BodyDef(BodyType.DYNAMIC);
    float halfWidth = 1f / columns;
    float halfHeight = 0.5f / rows;
    for (int i = 0; i < columns; i++) {
      for (int k = 0; k < rows; k++) {
        float x = -1 + halfWidth * (2 * i + 1);
        def.shape(new Box(halfWidth, halfHeight, x, -0.5f + halfHeight * (2 * k + 1)));
      }
    }
    return w.createBody(def, columns + " x " + rows);
  }

  @Test
  void anExplosionSeesTheBodyAndNotItsCut() {
    for (int i = 0; i < 40; i++) {
      float x = 4 * random.nextFloat() - 2;
      if (i % 5 == 1) { // beside a seam, where the corner of the next piece is as near
        x = 0.5f * random.nextInt(5) - 1 + (random.nextFloat() - 0.5f) * 0.002f;
      }
      float y = i % 4 == 0 ? 0.2f : -0.6f - 2 * random.nextFloat();
      float[] expected = null;
      for (int[] cut : new int[][] {{1, 1}, {1, 2}, {2, 2}, {1, 5}, {4, 1}}) {
        World<String> w = new World<>(new WorldDef().withGravity(0, 0));
        Body<String> b = cut(w, cut[0], cut[1]);
        new Explosion(x, y, 5).impulse(50).explode(w);
        w.step(1 / 60f);
        float[] motion = {b.velocityX(), b.velocityY(), b.angularVelocity()};
        expected = expected == null ? motion : expected;
        for (int n = 0; n < 3; n++) {
          float tolerance = 1e-3f * (1 + Math.abs(expected[n]));
          assertEquals(expected[n], motion[n], tolerance, "seed=" + seed + " " + b.user());
        }
      }
    }
  }

  @Test
  void aWindSeesTheBodyAndNotItsCut() {
    for (int i = 0; i < 40; i++) {
      Wind wind = new Wind(new Aabb(-9, -9, 9, 9), 20 * random.nextFloat(), 8).lift(1.2f);
      float angle = 6 * random.nextFloat();
      float[] expected = null;
      for (int[] cut : new int[][] {{1, 1}, {1, 2}, {3, 3}, {1, 5}, {8, 1}}) {
        World<String> w = new World<>(new WorldDef().withGravity(0, 0));
        Body<String> b = cut(w, cut[0], cut[1]);
        b.setPose(0, 0, angle);
        for (int step = 0; step < 10; step++) {
          wind.apply(w, 1 / 60f);
          w.step(1 / 60f);
        }
        float[] motion = {b.velocityX(), b.velocityY(), b.angularVelocity()};
        expected = expected == null ? motion : expected;
        for (int n = 0; n < 3; n++) {
          float tolerance = 2e-3f * (1 + Math.abs(expected[n]));
          assertEquals(expected[n], motion[n], tolerance, "seed=" + seed + " " + b.user());
        }
      }
    }
  }

  @Test
  void anOutlineMayBeThin() {
    assertEquals(1, Polygon.of(0, 0, 100, 0, 100, 0.01f, 0, 0.01f).area(), 1e-4);
    for (int i = 0; i < 500; i++) {
      double length = Math.pow(10, 3 * random.nextDouble());
      double width = 0.0015 + random.nextDouble() * Math.min(0.1, length / 50);
      double angle = 2 * Math.PI * random.nextDouble();
      double ax = length * Math.cos(angle) / 2;
      double ay = length * Math.sin(angle) / 2;
      double bx = -width * Math.sin(angle) / 2;
      double by = width * Math.cos(angle) / 2;
      double[] at = {-ax - bx, -ay - by, ax - bx, ay - by, ax + bx, ay + by, bx - ax, by - ay};
      float[] xy = new float[8];
      for (int k = 0; k < 8; k++) {
        xy[k] = (float) at[k];
      }
      String told = "seed=" + seed + " length=" + length + " width=" + width;
      double grain = 4 * Math.ulp((float) length);
      assertEquals(length * width, Polygon.of(xy).area(), length * (grain + 1e-6), told);
    }
  }

  @Test
  void aShapeThatIsCutHasTheSameMass() {
    World<String> w = new World<>(new WorldDef());
    Body<String> whole = cut(w, 1, 1);
    Body<String> parts = cut(w, 4, 5);
    assertEquals(whole.mass(), parts.mass(), 1e-5);
    assertEquals(whole.inertia(), parts.inertia(), 1e-5);
    assertTrue(parts.shapeCount() == 20);
  }
}
