package carom.physics.truth;

import static carom.physics.truth.Lab.DT;
import static carom.physics.truth.Lab.body;
import static carom.physics.truth.Lab.box;
import static carom.physics.truth.Lab.disc;
import static carom.physics.truth.Lab.fixed;
import static carom.physics.truth.Lab.seconds;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.lab.bench.CompoundPiles;
import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Collision;
import carom.physics.CollisionListener;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Polygon;
import carom.physics.math.SimRandom;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneRun;
import carom.sim.scene.Scenes;
import carom.suite.Optimized;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What should stand stands, what should hold holds; sizes and limits as in the list. */
@Optimized("computes for long")
final class StabilityTest {
  private static final Material M = Material.DEFAULT;

  private static World<String> awake(Material m) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    fixed(w, new Box(1000, 1), 0, -1, 0, m);
    return w;
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 5, 10, 15, 20})
  void stacksStandStill(int boxes) {
    World<String> w = awake(M);
    for (int i = 0; i < boxes; i++) {
      box(w, 0, .5 + i, .5, .5, M);
    }
    seconds(w, 20);
    assertTrue(Lab.kinetic(w) < 1e-3, "energy=" + Lab.kinetic(w));
    assertTrue(Lab.deepest(w) < .03, "deepest=" + Lab.deepest(w));
    for (int i = 0; i < boxes; i++) {
      Body<String> b = w.body(1 + i);
      assertEquals(0, b.x(), .1, "box " + i);
      assertEquals(.5 + i, b.y(), .02 + .0005 * boxes * boxes, "box " + i);
      assertEquals(0, b.angle(), .02, "box " + i);
    }
  }

  /** Every shape with flat sides stacks. */
  @ParameterizedTest
  @EnumSource(
      value = Lab.Solid.class,
      names = {"BOX", "CAPSULE", "HEXAGON", "ROUNDED"})
  void flatShapesStackEightHigh(Lab.Solid solid) {
    World<String> w = awake(M);
    for (int i = 0; i < 8; i++) {
      body(w, solid.shape, 0, .5 + i, M);
    }
    seconds(w, 10);
    assertTrue(Lab.kinetic(w) < .01, "energy=" + Lab.kinetic(w));
    assertEquals(7.5, w.body(8).y(), .1);
  }

  /** A heavy box on light ones sinks in, but doesn't crush them. */
  @ParameterizedTest
  @CsvSource({"1,10", "1,100", "3,10", "3,30"})
  void heavyBoxesRestOnLightOnes(int light, float ratio) {
    World<String> w = awake(M);
    for (int i = 0; i < light; i++) {
      box(w, 0, .5 + i, .5, .5, M);
    }
    Body<String> top = box(w, 0, .5 + light, .5, .5, M.withDensity(ratio));
    seconds(w, 10);
    assertEquals(.5 + light, top.y(), .1 * light, "y");
    assertEquals(0, top.x(), .1);
    assertTrue(Lab.kinetic(w) < .05, "energy=" + Lab.kinetic(w));
  }

  @ParameterizedTest
  @ValueSource(floats = {10, 100, 1000})
  void lightBoxesRestOnHeavyOnes(float ratio) {
    World<String> w = awake(M);
    box(w, 0, .5, .5, .5, M.withDensity(ratio));
    Body<String> top = box(w, 0, 1.5, .5, .5, M);
    seconds(w, 5);
    assertEquals(1.5, top.y(), .01);
    assertTrue(Lab.kinetic(w) < 1e-3, "energy=" + Lab.kinetic(w));
  }

  /** A thousand times heavier on a rope. */
  @ParameterizedTest
  @ValueSource(floats = {10, 100, 1000})
  void heavyLoadsHangOnLightChains(float ratio) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> last = null;
    for (int i = 0; i < 10; i++) {
      Body<String> b = box(w, 0, -.25 - .5 * i, .1, .25, M);
      w.createJoint(JointDef.revolute(last, b, 0, -.5f * i));
      last = b;
    }
    Body<String> load = box(w, 0, -5.5, .5, .5, M.withDensity(ratio * .05f));
    w.createJoint(JointDef.revolute(last, load, 0, -5));
    seconds(w, 10);
    assertTrue(Sanity.widestGap(w) < .001 * ratio, "gap=" + Sanity.widestGap(w));
    assertTrue(Lab.kinetic(w) < .01 * ratio, "energy=" + Lab.kinetic(w));
  }

  @Test
  void theCardHouseStands() {
    World<String> w = awake(new Material(1, .8f, 0));
    Material m = new Material(1, .8f, 0);
    double lean = .35;
    double half = 1;
    for (int side = -1; side <= 1; side += 2) {
      for (int k = 0; k < 2; k++) {
        double y = half * Math.cos(lean) + .05 * Math.sin(lean);
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Box(.05f, (float) half), m)
                .position(
                    (float) (1.45 * (k * 2 - 1) + side * (half * Math.sin(lean) + .05)), (float) y)
                .angle((float) (side * lean)),
            "card");
      }
    }
    seconds(w, 2);
    double top = 2 * half * Math.cos(lean) + .1;
    box(w, 0, top + .06, 2.2, .05, m);
    seconds(w, 15);
    assertEquals(top, w.body(5).y(), .15, "the roof");
    assertTrue(Lab.kinetic(w) < .01, "energy=" + Lab.kinetic(w));
  }

  /** Voussoirs without mortar: a half circle of wedges carries itself by friction alone. */
  @Test
  void anArchOfWedgesStands() {
    Material m = new Material(1, .9f, 0);
    World<String> w = awake(m);
    int stones = 9;
    for (int i = 0; i < stones; i++) {
      double a = Math.PI * i / stones;
      double b = Math.PI * (i + 1) / stones;
      float[] xy = new float[8];
      double[] radii = {4, 5.4};
      for (int k = 0; k < 4; k++) {
        double angle = k < 2 ? a : b;
        double r = radii[k == 0 || k == 3 ? 0 : 1];
        xy[2 * k] = (float) (r * Math.cos(angle));
        xy[2 * k + 1] = (float) (r * Math.sin(angle));
      }
      w.createBody(new BodyDef(BodyType.DYNAMIC).shape(Polygon.of(xy), m), "stone");
    }
    seconds(w, 10);
    assertTrue(Lab.kinetic(w) < .02, "energy=" + Lab.kinetic(w));
    double top = w.body(5).centerY();
    assertTrue(top > 4.4, "keystone at " + top);
  }

  /** Each domino knocks over the next; the wave runs at a steady speed. */
  @Test
  void dominoesFallOneAfterTheOther() {
    World<String> w = awake(M);
    List<Body<String>> row = new ArrayList<>();
    for (int i = 0; i < 30; i++) {
      row.add(box(w, i, 1, .1, 1, M));
    }
    seconds(w, 1);
    row.get(0).applyImpulse(.5f, 0, 0, 2);
    double[] fell = new double[30];
    for (int tick = 0; tick < 900; tick++) {
      w.step(DT);
      for (int i = 0; i < 30; i++) {
        if (fell[i] == 0 && row.get(i).angle() < -.3) {
          fell[i] = tick / 60.0;
        }
      }
    }
    for (int i = 1; i < 30; i++) {
      assertTrue(fell[i] > fell[i - 1], i + " at " + fell[i]);
    }
    double early = (fell[15] - fell[10]) / 5;
    double late = (fell[27] - fell[17]) / 10;
    assertEquals(early, late, .2 * early, "seconds from one to the next");
  }

  /** 100 rows, 5,050 boxes: it sways a little while it settles, and stands. */
  @Test
  void thePyramidOfAHundredRowsStands() {
    SceneRun run = Scenes.get("large_pyramid").start();
    run.steps(240);
    for (int i = 0; i < 100; i++) {
      run.step();
      double energy = Lab.kinetic(run.world());
      assertTrue(energy < 50, "tick=" + run.tick() + " energy=" + energy);
    }
    Sanity.Overlaps overlaps = Sanity.overlaps(run.world());
    assertTrue(overlaps.deepest() < .03, overlaps.toString());
    Body<String> top = run.world().body(5050);
    assertEquals(99.5, top.y(), 1, "the top");
    assertEquals(0, top.x(), 1, "the top");
  }

  @Test
  void thePileOf2000HasFewDeepOverlaps() {
    SceneRun run = Scenes.get("pile_2k").start();
    run.steps(480);
    Sanity.Overlaps overlaps = Sanity.overlaps(run.world());
    assertTrue(overlaps.deep() < 50, overlaps.toString());
    assertTrue(overlaps.deepest() < .05, overlaps.toString());
    assertTrue(Sanity.lowest(run.world()) > 0, "lowest=" + Sanity.lowest(run.world()));
    assertTrue(Lab.kinetic(run.world()) < 50, "energy=" + Lab.kinetic(run.world()));
  }

  /** 1,500 bodies of three parts each come to rest, and all of them sleep after ten seconds. */
  @Test
  void thePileOfCompoundsFallsAsleep() {
    Scene pile = Scenes.get("pile_compounds");
    SceneRun run = pile.with(pile.def().withSleeping(true)).start();
    run.steps(200);
    int[] awake = {0};
    run.world().forEachAwake(b -> awake[0] += b.type() == BodyType.DYNAMIC ? 1 : 0);
    assertTrue(awake[0] > 1450, "awake=" + awake[0] + ": nearly all fall or tremble at first");
    run.steps(400);
    awake[0] = 0;
    run.world().forEachAwake(b -> awake[0] += b.type() == BodyType.DYNAMIC ? 1 : 0);
    assertEquals(0, awake[0], "energy=" + Lab.kinetic(run.world()));
  }

  /**
   * So do other piles. In each of these some corner stands on a face with both of its edges equally
   * steep; when it lost its load there, the pile never came to rest, or ten seconds later.
   */
  @ParameterizedTest
  @ValueSource(strings = {"C4w", "T1w", "X1w", "X2w", "E1h", "M2h", "X3h", "X4h"})
  void pilesOfCompoundsFallAsleep(String name) {
    SceneRun run = CompoundPiles.pile(name).start();
    run.steps(700); // X3h takes 620
    int[] awake = {0};
    run.world().forEachAwake(b -> awake[0] += b.type() == BodyType.DYNAMIC ? 1 : 0);
    assertEquals(0, awake[0], "energy=" + Lab.kinetic(run.world()));
  }

  /** The net falls, snaps taut and swings: no joint opens by 0.6 m in any of the 300 steps. */
  @Test
  void theNetOf10000HoldsThroughoutItsFall() {
    SceneRun run = Scenes.get("joint_grid").start();
    double widest = 0;
    for (int i = 0; i < 300; i++) {
      run.step();
      widest = Math.max(widest, Sanity.widestGap(run.world()));
    }
    assertTrue(widest < .6, "gap=" + widest);
  }

  @ParameterizedTest
  @ValueSource(floats = {0, 1})
  void theGasOfAThousandKeepsItsEnergy(float threshold) {
    Scene gas = Scenes.get("gas_1k");
    SceneRun run = gas.with(gas.def().withRestitutionThreshold(threshold)).start();
    double before = Lab.kinetic(run.world());
    run.steps(300);
    assertEquals(before, Lab.kinetic(run.world()), .005 * before);
  }

  /**
   * As many discs on as much space, but without walls momentum can't go anywhere; of boxes energy
   * goes into turning.
   */
  @ParameterizedTest
  @CsvSource({"true,0", "true,1", "false,0", "false,1"})
  void anIsolatedGasKeepsMomentumAndEnergy(boolean discs, float threshold) {
    World<String> w =
        new World<>(
            new WorldDef()
                .withSleeping(false)
                .withGravity(0, 0)
                .withRestitutionThreshold(threshold));
    SimRandom r = new SimRandom(7);
    Material m = new Material(1, 0, 1);
    for (int i = 0; i < 1000; i++) {
      int row = i / 32;
      double x = (i % 32 - 15.5) * 3;
      double y = (row - 15.5) * 3;
      Body<String> b = discs ? disc(w, x, y, .25, m) : box(w, x, y, .22, .22, m);
      // Towards the middle, so that they meet before they part for ever.
      b.setVelocity(
          (float) (-.1 * x + 10 * r.nextFloat() - 5), (float) (-.1 * y + 10 * r.nextFloat() - 5));
    }
    double energy = Lab.kinetic(w);
    double[] before = Lab.momentum(w);
    int[] hits = new int[1];
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            hits[0]++;
          }
        });
    Lab.steps(w, 300);
    assertTrue(hits[0] > 300, "hits=" + hits[0]);
    double[] after = Lab.momentum(w);
    assertEquals(before[0], after[0], 1e-5 * before[3]);
    assertEquals(before[1], after[1], 1e-5 * before[3]);
    assertEquals(energy, Lab.kinetic(w), (discs ? .005 : .03) * energy);
  }
}
