package carom.physics.truth;

import static carom.physics.truth.Lab.DT;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Impacts that follow one another, and what they leave of the energy. A blow between two bodies
 * turns their speed of approach around times e; blows in a row exchange speeds one after the other.
 */
final class ImpactTest {
  private static final Material ELASTIC = new Material(1, 0, 1);

  /** The first of five equal discs is struck: the last one leaves with its speed. */
  @ParameterizedTest
  @ValueSource(doubles = {.1, .02, .005, 0})
  void aRowOfDiscsHandsTheSpeedOn(double gap) {
    World<String> w = Lab.space();
    List<Body<String>> row = new ArrayList<>();
    for (int i = 0; i < 5; i++) {
      row.add(Lab.disc(w, i * (1 + gap) + (i > 0 ? .5 : 0), 0, .5, ELASTIC));
    }
    row.get(0).setVelocity(3, 0);
    Lab.seconds(w, 2);
    for (int i = 0; i < 4; i++) {
      assertEquals(0, row.get(i).velocityX(), .03, "disc " + i);
    }
    assertEquals(3, row.get(4).velocityX(), .03);
  }

  /** Over any gap up to 10 cm, wherever in a step of 5 cm the first disc arrives. */
  @ParameterizedTest
  @ValueSource(doubles = {.25, .5})
  void aRowHandsTheSpeedOnOverAnyGap(double radius) {
    for (int mm = 0; mm <= 100; mm++) {
      for (int phase = 0; phase < 5; phase++) {
        World<String> w = Lab.space();
        Body<String> last = null;
        for (int i = 0; i < 5; i++) {
          double x = i * (2 * radius + mm / 1000.0) + (i > 0 ? .5 + phase / 100.0 : 0);
          last = Lab.disc(w, x, 0, radius, ELASTIC);
          last.setVelocity(i == 0 ? 3 : 0, 0);
        }
        Lab.seconds(w, 1);
        assertEquals(3, last.velocityX(), .03, "gap=" + mm + " mm phase=" + phase);
      }
    }
  }

  /** Rows of any length and order of creation. */
  @ParameterizedTest
  @CsvSource({"3,1", "5,2", "12,3", "20,4"})
  void aRowMadeInAnyOrderHandsTheSpeedOn(int discs, long seed) {
    World<String> w = Lab.space();
    List<Integer> places = new ArrayList<>();
    for (int i = 1; i < discs; i++) {
      places.add(i);
    }
    java.util.Collections.shuffle(places, new java.util.Random(seed));
    Body<String> last = null;
    for (int place : places) {
      Body<String> b = Lab.disc(w, place, 0, .5, ELASTIC);
      last = place == discs - 1 ? b : last;
    }
    Lab.disc(w, -.7, 0, .5, ELASTIC).setVelocity(3, 0);
    Lab.seconds(w, 1);
    assertEquals(3, last.velocityX(), .05, "seed=" + seed);
    assertEquals(.5 * last.mass() * 9, Lab.kinetic(w), .005 * 4.5 * last.mass(), "energy");
  }

  /** Newton's cradle of three touching balls on rods: the first falls, the last rises. */
  @Test
  void theLastBallOfACradleLeavesAtTheSpeedOfTheFirst() {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> ground = Lab.fixed(w, new Box(.1f, .1f), 0, 20, 0, ELASTIC);
    Body<String>[] balls = balls(w, ground);
    double v = Math.sqrt(2 * 10 * (5 - 5 * Math.cos(.6)));
    double fastest = 0;
    double arrived = 0;
    for (int i = 0; i < 100; i++) {
      arrived = Math.max(arrived, balls[0].velocityX());
      w.step(DT);
      fastest = Math.max(fastest, balls[2].velocityX());
    }
    assertEquals(v, arrived, .05 * v);
    assertTrue(fastest > .967 * v, "arrived at " + v + ", left at " + fastest);
  }

  @SuppressWarnings({"unchecked", "rawtypes"})
  private static Body<String>[] balls(World<String> w, Body<String> ground) {
    Body<String>[] balls = new Body[3];
    for (int i = 0; i < 3; i++) {
      double angle = i == 0 ? -.6 : 0;
      double x = i + 5 * Math.sin(angle);
      double y = 5 - 5 * Math.cos(angle);
      balls[i] = Lab.disc(w, x, y, .5, ELASTIC);
      w.createJoint(JointDef.distance(ground, balls[i], i, 5, (float) x, (float) y));
    }
    return balls;
  }

  /**
   * Fifteen balls in a triangle, struck at 8 m/s with e = .95, are left with the energy that single
   * blows leave, computed from one to the next. A central blow loses (1 - e^2) / 2, or 5 %, of the
   * energy of its approach; all 30 together lose 21 %.
   */
  @Test
  void aBreakLosesWhatItsBlowsLose() {
    World<String> w = Lab.space();
    float e = .95f;
    Material ivory = new Material(1, 0, e);
    double[][] discs = new double[16][4];
    int n = 0;
    for (int row = 0; row < 5; row++) {
      for (int i = 0; i <= row; i++) {
        double x = row * .5 * 1.7321;
        double y = i - row / 2.0;
        Lab.disc(w, x, y, .5, ivory);
        discs[n++] = new double[] {1.00001 * x, 1.00001 * y, 0, 0};
      }
    }
    Lab.disc(w, -3, .01, .5, ivory).setVelocity(8, 0);
    discs[n] = new double[] {-3, .01, 8, 0};
    double before = Lab.kinetic(w);
    Lab.seconds(w, 1);
    double left = Lab.kinetic(w) / before;
    double exact = blowByBlow(discs, e, 1) / 64;
    assertEquals(.786, exact, .001);
    assertEquals(exact, left, .01);
  }

  /** Moves equal discs of radius .5 from blow to blow and returns the sum of their v^2. */
  private static double blowByBlow(double[][] discs, double e, double seconds) {
    double now = 0;
    while (now < seconds) {
      double next = seconds - now;
      double[] a = null;
      double[] b = null;
      for (int i = 0; i < discs.length; i++) {
        for (int j = 0; j < i; j++) {
          double time = meeting(discs[i], discs[j]);
          if (time < next) {
            next = time;
            a = discs[i];
            b = discs[j];
          }
        }
      }
      for (double[] d : discs) {
        d[0] += d[2] * next;
        d[1] += d[3] * next;
      }
      now += next;
      if (a != null) {
        double nx = a[0] - b[0];
        double ny = a[1] - b[1];
        double square = nx * nx + ny * ny;
        double k = (1 + e) / 2 * ((a[2] - b[2]) * nx + (a[3] - b[3]) * ny) / square;
        a[2] -= k * nx;
        a[3] -= k * ny;
        b[2] += k * nx;
        b[3] += k * ny;
      }
    }
    double sum = 0;
    for (double[] d : discs) {
      sum += d[2] * d[2] + d[3] * d[3];
    }
    return sum;
  }

  private static double meeting(double[] a, double[] b) {
    double x = a[0] - b[0];
    double y = a[1] - b[1];
    double vx = a[2] - b[2];
    double vy = a[3] - b[3];
    double approach = -(x * vx + y * vy);
    double gap = Math.max(x * x + y * y - 1, 0);
    double root = approach * approach - (vx * vx + vy * vy) * gap;
    return approach < 1e-9 || root < 0 ? Double.MAX_VALUE : gap / (approach + Math.sqrt(root));
  }

  /** An isolated, dense gas keeps its energy; in a closed box it does nearly. */
  @ParameterizedTest
  @CsvSource({"false,.005,1", "true,.02,1", "false,.005,2", "true,.02,2"})
  void aGasKeepsItsEnergy(boolean closed, double tolerance, long seed) {
    World<String> w = Lab.lively();
    SplittableRandom random = new SplittableRandom(seed);
    for (int i = 0; i < 1000; i++) {
      int row = i / 32;
      double x = (i % 32 - 15.5) * .55 + random.nextDouble(-.02, .02);
      double y = (row - 15.5) * .55 + random.nextDouble(-.02, .02);
      Lab.disc(w, x, y, .25, ELASTIC)
          .setVelocity((float) random.nextDouble(-5, 5), (float) random.nextDouble(-5, 5));
    }
    for (int side = -1; closed && side <= 1; side += 2) {
      Lab.fixed(w, new Box(1, 12), side * 11, 0, 0, ELASTIC);
      Lab.fixed(w, new Box(12, 1), 0, side * 11, 0, ELASTIC);
    }
    double before = Lab.kinetic(w);
    Lab.steps(w, 600);
    assertEquals(1, Lab.kinetic(w) / before, tolerance, "seed=" + seed);
  }

  /** Energy with the velocities of now; those that a step ends with are of half a substep ago. */
  private static double energy(World<String> w) {
    double[] sum = {Lab.energy(w)};
    w.forEachBody(b -> sum[0] -= b.mass() * b.velocityY() * Lab.G * Lab.H / 2);
    return sum[0];
  }

  /** A box that lands tilted on one corner, or both, keeps its energy for a minute. */
  @ParameterizedTest
  @ValueSource(doubles = {0, .02, .1, .3, .5, .7853})
  void aTiltedBoxKeepsItsEnergy(double angle) {
    World<String> w = Lab.floor(Lab.ICE);
    Body<String> b = Lab.box(w, 0, 3, .5, .3, ELASTIC);
    b.setPose(0, 3, (float) angle);
    double before = energy(w);
    for (int i = 0; i < 3600; i++) {
      w.step(DT);
      double now = energy(w) / before;
      assertTrue(now < 1.001, "tick=" + i + " energy=" + now);
    }
    assertTrue(energy(w) > .98 * before, "left: " + energy(w) / before);
  }

  /** Forty boxes that bounce among each other in a bin for a minute gain nothing. */
  @ParameterizedTest
  @CsvSource({"0,1", ".5,2"})
  void bouncingBoxesGainNoEnergy(float friction, long seed) {
    World<String> w = Lab.floor(new Material(1, friction, 0));
    Material m = new Material(1, friction, 1);
    Lab.fixed(w, new Box(1, 30), -6, 30, 0, ELASTIC);
    Lab.fixed(w, new Box(1, 30), 6, 30, 0, ELASTIC);
    SplittableRandom random = new SplittableRandom(seed);
    for (int i = 0; i < 40; i++) {
      int layer = i / 5;
      Body<String> b = Lab.box(w, (i % 5 - 2) * 1.8, 2 + 1.5 * layer, .5, .3, m);
      b.setPose(b.x(), b.y(), (float) random.nextDouble(-1, 1));
    }
    double before = energy(w);
    double most = 0;
    for (int i = 0; i < 3600; i++) {
      w.step(DT);
      most = Math.max(most, energy(w) / before);
    }
    assertTrue(most <= 1.005, "most=" + most);
    assertTrue(friction > 0 || energy(w) > .8 * before, "left: " + energy(w) / before);
  }
}
