package carom.physics.dynamics.narrow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.physics.collision.Manifold;
import carom.physics.dynamics.contact.KeptManifolds;
import carom.physics.geometry.Box;
import carom.physics.math.Transform;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The kernel says what {@link KeptManifolds} says, bit for bit. */
final class BoxLanesTest {
  private static final int LANES = BoxLanes.LANES;
  private static final float SPECULATIVE = 0.02f;

  /** Enough for all kinds of pairs, on a processor with 8 lanes as on one with 16. */
  private static final int PAIRS = 320_000;

  private final BoxLanes lanes = BoxLanes.FOUND;
  private final Box[] boxA = new Box[LANES];
  private final Box[] boxB = new Box[LANES];
  private final Transform[] poseA = new Transform[LANES];
  private final Transform[] poseB = new Transform[LANES];
  private final KeptManifolds.Scratch scratch = new KeptManifolds.Scratch();
  private final Manifold expected = new Manifold();

  private int faces;
  private int pairs;
  private int corners;
  private int none;

  /** Goal: same points, same bits. Method: boxes of all sizes and turns, apart, close and deep. */
  @Test
  void kernelAndScalarAgree() {
    assumeTrue(lanes != null, "this JVM has no vectors of 8 floats");
    for (long seed = 1; seed <= PAIRS / LANES; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      for (int lane = 0; lane < LANES; lane++) {
        put(random, lane);
      }
      compare("seed=" + seed);
    }
    String seen = "faces=" + faces + " of two points=" + pairs + " corners=" + corners;
    assertTrue(faces > 20_000 && pairs > 10_000 && corners > 2_000 && none > 20_000, seen);
  }

  private void put(SplittableRandom random, int lane) {
    boxA[lane] = box(random);
    boxB[lane] = random.nextInt(3) == 0 ? boxA[lane] : box(random);
    double far = random.nextInt(8) == 0 ? 5_000 : 3;
    poseA[lane] = new Transform();
    poseB[lane] = new Transform();
    turn(poseA[lane], random);
    turn(poseB[lane], random);
    poseA[lane].x = (float) random.nextDouble(-far, far);
    poseA[lane].y = (float) random.nextDouble(-far, far);
    // Mostly about as far apart as they touch, along an axis or slanting.
    double reach = reach(boxA[lane]) + reach(boxB[lane]);
    double way = random.nextDouble(0.3, 1.1) * reach;
    double angle =
        random.nextInt(3) == 0
            ? random.nextInt(8) * Math.PI / 4
            : random.nextDouble(-Math.PI, Math.PI);
    poseB[lane].x = poseA[lane].x + (float) (way * Math.cos(angle));
    poseB[lane].y = poseA[lane].y + (float) (way * Math.sin(angle));
    if (random.nextInt(4) == 0) {
      rest(random, lane);
    }
  }

  /** Puts B on a side of A, with a gap or overlap of a millimetre or none. */
  private void rest(SplittableRandom random, int lane) {
    Transform a = poseA[lane];
    float gap = random.nextInt(-1, 2) * 1e-3f;
    float up = boxA[lane].halfHeight() + boxB[lane].halfHeight() + gap;
    float along = boxA[lane].halfWidth() * random.nextInt(-2, 3);
    float middleX = boxA[lane].centerX() - boxB[lane].centerX() + along;
    float middleY = boxA[lane].centerY() - boxB[lane].centerY() + up;
    poseB[lane].set(a.worldX(middleX, middleY), a.worldY(middleX, middleY), a.cos, a.sin);
  }

  private static void turn(Transform pose, SplittableRandom random) {
    double angle =
        switch (random.nextInt(4)) {
          case 0 -> random.nextInt(4) * Math.PI / 2;
          case 1 -> random.nextInt(8) * Math.PI / 4;
          default -> random.nextDouble(-Math.PI, Math.PI);
        };
    pose.cos = (float) Math.cos(angle);
    pose.sin = (float) Math.sin(angle);
    if (random.nextInt(8) == 0) {
      pose.cos = random.nextBoolean() ? 1 : -1;
      pose.sin = random.nextBoolean() ? 0f : -0f;
    }
  }

  private static Box box(SplittableRandom random) {
    double size = random.nextInt(10) == 0 ? 20 : random.nextInt(10) == 0 ? 0.02 : 0.5;
    float width = (float) (size * random.nextDouble(0.5, 2));
    float height = random.nextInt(3) == 0 ? width : (float) (size * random.nextDouble(0.5, 2));
    boolean central = random.nextBoolean();
    float x = central ? 0 : (float) random.nextDouble(-1, 1);
    return new Box(width, height, x, central ? 0 : (float) random.nextDouble(-1, 1));
  }

  private static float reach(Box box) {
    return (float)
        Math.hypot(
            Math.abs(box.centerX()) + box.halfWidth(), Math.abs(box.centerY()) + box.halfHeight());
  }

  private void compare(String message) {
    float[] s = new float[lanes.scratchSize()];
    for (int lane = 0; lane < LANES; lane++) {
      s[BoxLanes.WAY_X + lane] = poseB[lane].x - poseA[lane].x;
      s[BoxLanes.WAY_Y + lane] = poseB[lane].y - poseA[lane].y;
      s[BoxLanes.COS_A + lane] = poseA[lane].cos;
      s[BoxLanes.SIN_A + lane] = poseA[lane].sin;
      s[BoxLanes.COS_B + lane] = poseB[lane].cos;
      s[BoxLanes.SIN_B + lane] = poseB[lane].sin;
      s[BoxLanes.REACH + lane] = reach(boxB[lane]);
      describe(boxA[lane], s, BoxLanes.HALF_WIDTH_A + lane);
      describe(boxB[lane], s, BoxLanes.HALF_WIDTH_B + lane);
    }
    lanes.collide(s, SPECULATIVE);
    float deepest = 0;
    for (int lane = 0; lane < LANES; lane++) {
      String where = message + " lane=" + lane;
      boolean cornersMet = find(lane);
      int count = BoxLanes.integer(s, BoxLanes.COUNT + lane);
      if (count == BoxLanes.CORNERS) {
        // Left to the scalar code: rightly so where it says so itself.
        corners++;
        continue;
      }
      assertEquals(false, cornersMet, where);
      if (expected.count == 0) {
        none++;
        assertEquals(0, count, where);
        continue;
      }
      faces++;
      pairs += expected.count - 1;
      float least = expected.minSeparation();
      deepest = Math.min(deepest, least);
      boolean look = least > SPECULATIVE - KeptManifolds.slack(reach(boxB[lane]));
      assertEquals(expected.count + (look ? BoxLanes.LOOK : 0), count, where);
      assertSame(expected.normalX, s[BoxLanes.NX + lane], where);
      assertSame(expected.normalY, s[BoxLanes.NY + lane], where);
      assertSame(expected.x0, s[BoxLanes.X0 + lane], where);
      assertSame(expected.y0, s[BoxLanes.Y0 + lane], where);
      assertSame(expected.separation0, s[BoxLanes.GAP0 + lane], where);
      assertEquals(expected.id0, BoxLanes.integer(s, BoxLanes.ID0 + lane), where);
      assertEquals(expected.otherId0, BoxLanes.integer(s, BoxLanes.OTHER_ID0 + lane), where);
      if (expected.count == 2) {
        assertSame(expected.x1, s[BoxLanes.X1 + lane], where);
        assertSame(expected.y1, s[BoxLanes.Y1 + lane], where);
        assertSame(expected.separation1, s[BoxLanes.GAP1 + lane], where);
        assertEquals(expected.id1, BoxLanes.integer(s, BoxLanes.ID1 + lane), where);
        assertEquals(expected.otherId1, BoxLanes.integer(s, BoxLanes.OTHER_ID1 + lane), where);
      }
    }
    float told = 0;
    for (int lane = 0; lane < LANES; lane++) {
      told = Math.min(told, s[BoxLanes.LEAST + lane]);
    }
    assertEquals(deepest, told, message);
  }

  /** Also the signs of zeros. */
  private static void assertSame(float wanted, float found, String message) {
    assertEquals(Float.floatToRawIntBits(wanted), Float.floatToRawIntBits(found), message);
  }

  private static void describe(Box box, float[] s, int at) {
    s[at] = box.halfWidth();
    s[at + LANES] = box.halfHeight();
    s[at + 2 * LANES] = box.centerX();
    s[at + 3 * LANES] = box.centerY();
  }

  /** What the scalar code says; answers whether two corners that are apart made the normal. */
  private boolean find(int lane) {
    KeptManifolds kept = new KeptManifolds();
    kept.ensure(1);
    int[] hints = new int[1];
    Box b = boxB[lane];
    kept.collide(
        0,
        boxA[lane],
        poseA[lane],
        b,
        poseB[lane],
        reach(b),
        SPECULATIVE,
        hints,
        scratch,
        expected);
    return expected.count > 0 && !kept.ofFace(0, expected.count, expected.id0, expected.id1);
  }
}
