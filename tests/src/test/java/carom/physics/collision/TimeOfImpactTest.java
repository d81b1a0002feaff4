package carom.physics.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.collision.TimeOfImpact.State;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.math.Transform;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class TimeOfImpactTest {
  private static final float TARGET = 0.005f;
  private static final int SAMPLES = 200;

  private final TimeOfImpact impact = new TimeOfImpact();
  private final Distance distance = new Distance();
  private final ClosestPoints points = new ClosestPoints();
  private final Sweep sa = new Sweep();
  private final Sweep sb = new Sweep();
  private final Transform ta = new Transform();
  private final Transform tb = new Transform();

  private float gapAt(Convex a, Convex b, float fraction) {
    sa.at(fraction, ta);
    sb.at(fraction, tb);
    return distance.between(a, ta, b, tb, points);
  }

  /** Goal: never too late, and not early without reason. Method: sample the motion. */
  @Test
  void agreesWithSamplingForMovingAndTurningShapes() {
    int[] seen = new int[State.values().length];
    for (int kinds = 0; kinds < Oracle.KINDS * Oracle.KINDS; kinds++) {
      for (long seed = 1; seed <= 60; seed++) {
        SplittableRandom random = new SplittableRandom(seed);
        Convex a = Oracle.shape(kinds / Oracle.KINDS, random);
        Convex b = Oracle.shape(kinds % Oracle.KINDS, random);
        sa.set(Oracle.pose(random, 3), way(random, 5), way(random, 5), way(random, 2));
        sb.set(Oracle.pose(random, 1), way(random, 1), way(random, 1), way(random, 2));
        State state = impact.find(a, sa, b, sb, TARGET);
        seen[state.ordinal()]++;
        float end = impact.fraction();
        String message = "kinds=" + kinds + " seed=" + seed + " " + state + " fraction=" + end;
        if (state == State.OVERLAPPING) {
          assertEquals(0, end, message);
          assertEquals(0, gapAt(a, b, 0), 1e-6, message);
          continue;
        }
        for (int i = 0; i <= SAMPLES; i++) {
          float gap = gapAt(a, b, end * i / SAMPLES);
          assertTrue(gap > 0.45f * TARGET, message + " gap=" + gap + " at " + i);
        }
        if (state == State.TOUCHING && end > 0) {
          assertEquals(TARGET, gapAt(a, b, end), 0.26 * TARGET, message);
        }
      }
    }
    assertTrue(seen[State.TOUCHING.ordinal()] > 15 * Oracle.KINDS, message(seen));
    assertTrue(seen[State.SEPARATED.ordinal()] > 15 * Oracle.KINDS, message(seen));
    assertEquals(0, seen[State.UNDECIDED.ordinal()], message(seen));
  }

  private static String message(int[] seen) {
    return "separated, touching, overlapping, undecided: " + java.util.Arrays.toString(seen);
  }

  private static float way(SplittableRandom random, double reach) {
    return (float) random.nextDouble(-reach, reach);
  }

  @Test
  void aBulletMeetsAThinWallAtTheClosedFormTime() {
    Circle bullet = new Circle(0.01f);
    Box wall = new Box(0.005f, 2);
    float way = 1000 / 60f;
    sa.set(new Transform(-5, 0.3f, 0), way, 0, 0);
    sb.set(new Transform(), 0, 0, 0);
    assertEquals(State.TOUCHING, impact.find(bullet, sa, wall, sb, 0.001f));
    assertEquals((5 - 0.005 - 0.01 - 0.001) / way, impact.fraction(), 0.0003 / way);
  }

  @Test
  void aSpinningRodMeetsAPegAtTheClosedFormTime() {
    // A rod from the origin to the right, 2 m long and 2 cm thick, turns a quarter in one step; its
    // upper side meets a peg at 45 degrees, 1 m away, when the angle between is asin of the gap.
    Box rod = new Box(1, 0.01f, 1, 0);
    Circle peg = new Circle(0.05f);
    double quarter = Math.PI / 2;
    sa.set(new Transform(), 0, 0, (float) quarter);
    sb.set(new Transform((float) Math.sqrt(0.5), (float) Math.sqrt(0.5), 0), 0, 0, 0);
    assertEquals(State.TOUCHING, impact.find(rod, sa, peg, sb, 0.001f));
    double expected = (Math.PI / 4 - Math.asin(0.01 + 0.05 + 0.001)) / quarter;
    assertEquals(expected, impact.fraction(), 0.0003);
  }

  @Test
  void aBladeThatTurnsThroughAPegAndBackOutIsSeen() {
    // Half a turn in one step: at both ends the blade is far from the peg.
    Box blade = new Box(1, 0.01f);
    Circle peg = new Circle(0.02f, 0, 0.9f);
    sa.set(new Transform(), 0, 0, 3.1f);
    sb.set(new Transform(), 0, 0, 0);
    assertEquals(State.TOUCHING, impact.find(blade, sa, peg, sb, 0.001f));
    assertEquals(Math.PI / 2 / 3.1, impact.fraction(), 0.02);
  }

  @Test
  void restingAndTouchingHaveTheirAnswers() {
    Box box = new Box(0.5f, 0.5f);
    sa.set(new Transform(), 0, 0, 0);
    sb.set(new Transform(1.1f, 0, 0), 0, 0, 0);
    assertEquals(State.SEPARATED, impact.find(box, sa, box, sb, TARGET));
    assertEquals(1, impact.fraction());
    sb.set(new Transform(1.004f, 0, 0), 5, 0, 0);
    assertEquals(State.TOUCHING, impact.find(box, sa, box, sb, TARGET));
    assertEquals(0, impact.fraction());
    sb.set(new Transform(0.9f, 0, 0), 5, 0, 0);
    assertEquals(State.OVERLAPPING, impact.find(box, sa, box, sb, TARGET));
    assertEquals(0, impact.fraction());
    assertThrows(
        IllegalArgumentException.class, () -> impact.find(box, sa, box, sb, Float.MIN_VALUE));
  }

  @Test
  void aSweepBetweenPosesEndsAtTheSecond() {
    Transform from = new Transform(1, 2, 3);
    Transform to = new Transform(4, 6, -2.5f);
    sa.between(from, to).at(1, ta);
    assertEquals(to.x, ta.x);
    assertEquals(to.cos, ta.cos, 2e-7);
    assertEquals(to.sin, ta.sin, 2e-7);
    sa.at(0, ta);
    assertEquals(from.toString(), ta.toString());
    assertTrue(Math.abs(sa.angleRad) < Math.PI);
  }
}
