package carom.physics.dynamics.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.WorldDef;
import carom.physics.geometry.Chain;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

class BodyMakerTest {
  /** So many that their number doesn't fit an int: it would come out small or negative. */
  @Test
  void morePartsThanAnIntCanCountAreRefused() {
    float[] xy = new float[2 * (Chain.MAX_SEGMENTS + 1)];
    for (int i = 0; i < xy.length; i += 2) {
      xy[i] = i;
    }
    ShapeSpec spec = new ShapeSpec(Chain.open(xy), 1, 0, 0, 0, 0, 1, 1, 0, false, null, null);
    ShapeSpec[] shapes = new ShapeSpec[(1 << 30) / Chain.MAX_SEGMENTS * 4 + 10];
    Arrays.fill(shapes, spec);
    BodyStore bodies = new BodyStore();
    BodyMaker maker = new BodyMaker(bodies, new ShapeTable(new WorldDef()));
    IllegalArgumentException e =
        assertThrows(
            IllegalArgumentException.class,
            () -> maker.make(BodyStore.STATIC, shapes, null, false));
    long parts = (long) shapes.length * Chain.MAX_SEGMENTS;
    assertTrue(parts > 1L << 32, "parts=" + parts);
    assertTrue(e.getMessage().startsWith("parts=" + parts + " is more than"), e.getMessage());
    assertEquals(0, bodies.count());
  }
}
