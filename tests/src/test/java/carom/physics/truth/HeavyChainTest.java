package carom.physics.truth;

import static carom.physics.truth.Lab.DT;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.WorldState;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.threads.WorkerThreads;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Chains and other trees of hinges that carry far more than their links weigh. */
final class HeavyChainTest {
  private static final Material M = Material.DEFAULT;

  private static World<String> awake() {
    return new World<>(new WorldDef().withSleeping(false));
  }

  private static Body<String> box(
      World<String> w, double x, double y, double hx, double hy, double m) {
    return w.createBody(
        new BodyDef(BodyType.DYNAMIC)
            .shape(new Box((float) hx, (float) hy), M.withDensity((float) (m / (4 * hx * hy))))
            .position((float) x, (float) y),
        "link");
  }

  /** Links of a metre and a kilogram from the origin to the right; the last one is heavier. */
  private static List<Body<String>> levelChain(World<String> w, int links, double ratio) {
    List<Body<String>> chain = new ArrayList<>();
    for (int i = 0; i < links; i++) {
      Body<String> b = box(w, i + .5, 0, .5, .1, i == links - 1 ? ratio : 1);
      w.createJoint(JointDef.revolute(i == 0 ? null : chain.get(i - 1), b, i, 0));
      chain.add(b);
    }
    return chain;
  }

  private static double energy(World<String> w) {
    double[] e = {Lab.kinetic(w)};
    w.forEachBody(b -> e[0] += b.type() == BodyType.DYNAMIC ? b.mass() * Lab.G * b.centerY() : 0);
    return e[0];
  }

  /**
   * Let go level, the chain swings through its lowest point: no link is drawn away from the next.
   */
  @ParameterizedTest
  @CsvSource({
    "30,1000,31",
    "100,100,101",
    "5,300,4.55",
    "10,100,9.6",
    "10,1000,9.6",
    "10,10000,9.6",
    "20,50,19.7",
    "30,100,29.6",
    "60,300,59.7",
    "120,1,119.7",
    "200,50,199.7"
  })
  void theEndStaysWithinReach(int links, double ratio, double reach) {
    World<String> w = awake();
    List<Body<String>> chain = levelChain(w, links, ratio);
    Body<String> end = chain.get(links - 1);
    double before = energy(w);
    double farthest = 0;
    double most = 0;
    for (int i = 0; i < 600; i++) {
      w.step(DT);
      farthest = Math.max(farthest, Math.hypot(end.x(), end.y()));
      most = Math.max(most, energy(w) - before);
    }
    assertTrue(farthest <= reach, "farthest=" + farthest);
    double drop = (ratio + links / 2.0) * Lab.G * links;
    assertTrue(most < .003 * drop, "energy grew by " + most + " of " + drop);
    assertTrue(end.y() < 0, "it doesn't swing: y=" + end.y());
  }

  @ParameterizedTest
  @CsvSource({"30,1000", "100,100", "10,100000", "300,1"})
  void aHangingLoadHangsStill(int links, double ratio) {
    World<String> w = awake();
    Body<String> last = null;
    for (int i = 0; i < links; i++) {
      Body<String> b = box(w, 0, -.5 - i, .1, .5, i == links - 1 ? ratio : 1);
      w.createJoint(JointDef.revolute(last, b, 0, -i));
      last = b;
    }
    for (int i = 0; i < 300; i++) {
      w.step(DT);
    }
    assertEquals(.5 - links, last.y(), 1e-3 * links);
    Joint<String> top = w.joint(0);
    double weight = (ratio + links - 1) * Lab.G;
    assertEquals(weight, Math.hypot(top.forceX(), top.forceY()), .001 * weight);
  }

  /** Both ends are held: taut between two rocks, it has more equations than can be met. */
  @Test
  void aTautBridgeCarriesAHeavyLoad() {
    World<String> w = awake();
    int planks = 40;
    Body<String> last = null;
    Body<String> middle = null;
    for (int i = 0; i < planks; i++) {
      Body<String> b = box(w, i + .5, 0, .5, .1, 5);
      w.createJoint(JointDef.revolute(last, b, i, 0));
      last = b;
      middle = i == planks / 2 ? b : middle;
    }
    w.createJoint(JointDef.revolute(last, w.createBody(new BodyDef(), "rock"), planks, 0));
    Body<String> load = box(w, 20.5, -1.1, 1, 1, 500);
    w.createJoint(JointDef.revolute(middle, load, 20.5f, -.1f));
    double widest = 0;
    for (int i = 0; i < 1200; i++) {
      w.step(DT);
      widest = Math.max(widest, Sanity.widestGap(w));
    }
    assertTrue(widest < .02, "gap=" + widest);
    assertTrue(load.y() > -3, "y=" + load.y());
  }

  /** A body with four chains of limited hinges, whose ends are heavy, hangs from a fifth one. */
  private static World<String> mobile(WorldDef def, int balls) {
    World<String> w = new World<>(def);
    w.createBody(new BodyDef().shape(new Box(60, 1)).position(0, -31), "floor");
    Body<String> last = null;
    for (int i = 0; i < 6; i++) {
      Body<String> b = box(w, 0, -.5 - i, .1, .5, 1);
      w.createJoint(JointDef.revolute(last, b, 0, -i));
      last = b;
    }
    Body<String> hub = box(w, 0, -6.5, 3, .5, 3);
    w.createJoint(JointDef.revolute(last, hub, 0, -6));
    for (int limb = 0; limb < 4; limb++) {
      double x = -3 + 2 * limb;
      last = hub;
      for (int i = 0; i < 5; i++) {
        Body<String> b = box(w, x, -7.5 - i, .1, .5, i == 4 ? 100 + 10 * limb : 1);
        JointDef<String> hinge = JointDef.revolute(last, b, (float) x, -7 - i);
        w.createJoint(i % 2 == 0 ? hinge.limits(-.6f, .6f) : hinge);
        last = b;
      }
    }
    for (int i = 0; i < balls; i++) {
      w.createBody(
          new BodyDef(BodyType.DYNAMIC).shape(new Circle(.4f), M).position(i % 40 - 20, 2 + i / 40),
          "ball");
    }
    w.body(1).setAngularVelocity(1);
    return w;
  }

  @Test
  void aTreeWithLimitsAndContactsHolds() {
    World<String> w = mobile(new WorldDef().withSleeping(false), 80);
    double widest = 0;
    for (int i = 0; i < 1200; i++) {
      w.step(DT);
      widest = Math.max(widest, Sanity.widestGap(w));
    }
    assertTrue(widest < .05, "gap=" + widest);
  }

  /** A tree is no state: a world that was read, or restored, or has threads, goes on alike. */
  @Test
  void aTreeGoesOnToTheBitAfterRestoreAndWithThreads() {
    World<String> one = mobile(new WorldDef(), 600);
    World<String> two = mobile(new WorldDef(), 600);
    try (WorkerThreads threads = new WorkerThreads(2)) {
      two.workers(threads);
      WorldState saved = null;
      long[] hashes = new long[300];
      for (int i = 0; i < 300; i++) {
        if (i == 100) {
          saved = one.save(null);
        }
        one.step(DT);
        two.step(DT);
        hashes[i] = one.stateHash();
        assertEquals(hashes[i], two.stateHash(), "tick " + i);
      }
      one.restore(saved);
      for (int i = 100; i < 300; i++) {
        one.step(DT);
        assertEquals(hashes[i], one.stateHash(), "tick " + i + " after restore");
      }
      two.workers(null);
    }
  }

  /** Masses decide whether there is a tree, also when they change, or go back by a restore. */
  @Test
  void massesThatChangeMakeAndUnmakeATree() {
    World<String> w = awake();
    List<Body<String>> chain = levelChain(w, 8, 1);
    Body<String> end = chain.get(7);
    for (int i = 0; i < 20; i++) {
      w.step(DT);
    }
    WorldState light = w.save(null);
    end.setMass(500, 50, 0, 0);
    WorldState heavy = w.save(null);
    for (int i = 0; i < 60; i++) {
      w.step(DT);
    }
    long hash = w.stateHash();
    assertTrue(Sanity.widestGap(w) < .005, "gap=" + Sanity.widestGap(w));
    w.restore(light);
    for (int i = 0; i < 60; i++) {
      w.step(DT);
    }
    assertNotEquals(hash, w.stateHash());
    w.restore(heavy);
    for (int i = 0; i < 60; i++) {
      w.step(DT);
    }
    assertEquals(hash, w.stateHash());
  }

  /** Bodies made in another order move alike, if their joints are made in the same one. */
  @Test
  void theOrderOfBodiesChangesNoBit() {
    List<World<String>> worlds = new ArrayList<>();
    List<List<Body<String>>> chains = new ArrayList<>();
    for (int order = 0; order < 2; order++) {
      World<String> w = awake();
      List<Body<String>> chain = new ArrayList<>();
      for (int i = 0; i < 20; i++) {
        chain.add(null);
      }
      for (int k = 0; k < 20; k++) {
        int i = order == 0 ? k : (7 * k + 3) % 20;
        chain.set(i, box(w, i + .5, 0, .3, .1, i == 19 ? 400 : 1));
      }
      for (int i = 0; i < 20; i++) {
        w.createJoint(JointDef.revolute(i == 0 ? null : chain.get(i - 1), chain.get(i), i, 0));
      }
      worlds.add(w);
      chains.add(chain);
    }
    for (int tick = 0; tick < 120; tick++) {
      worlds.get(0).step(DT);
      worlds.get(1).step(DT);
    }
    for (int i = 0; i < 20; i++) {
      assertEquals(chains.get(0).get(i).x(), chains.get(1).get(i).x(), 0, "x of link " + i);
      assertEquals(chains.get(0).get(i).y(), chains.get(1).get(i).y(), 0, "y of link " + i);
    }
  }

  @Test
  void aHingeOfATreeBreaksUnderItsLoad() {
    World<String> w = awake();
    List<Body<String>> chain = new ArrayList<>();
    for (int i = 0; i < 10; i++) {
      Body<String> b = box(w, 0, -.5 - i, .1, .5, i == 9 ? 200 : 1);
      JointDef<String> hinge = JointDef.revolute(i == 0 ? null : chain.get(i - 1), b, 0, -i);
      w.createJoint(i == 4 ? hinge.breaksAt(1800, Float.POSITIVE_INFINITY) : hinge);
      chain.add(b);
    }
    for (int i = 0; i < 60; i++) {
      w.step(DT);
    }
    assertEquals(9, w.jointCount());
    assertTrue(chain.get(9).y() < -12, "y=" + chain.get(9).y());
    assertEquals(-3.5, chain.get(3).y(), .2);
  }

  /** Other chains beside a tree, or none: they are solved as if it weren't there. */
  @Test
  void aTreeFarAwayChangesNothing() {
    World<String> alone = awake();
    World<String> beside = awake();
    List<Body<String>> chain = levelChain(alone, 10, 1);
    List<Body<String>> same = levelChain(beside, 10, 1);
    Body<String> last = null;
    for (int i = 0; i < 5; i++) {
      Body<String> b = box(beside, 100.5 + i, 0, .5, .1, i == 4 ? 500 : 1);
      beside.createJoint(JointDef.revolute(last, b, 100 + i, 0));
      last = b;
    }
    for (int tick = 0; tick < 200; tick++) {
      alone.step(DT);
      beside.step(DT);
    }
    for (int i = 0; i < 10; i++) {
      assertEquals(chain.get(i).x(), same.get(i).x(), 0, "x of link " + i);
      assertEquals(chain.get(i).y(), same.get(i).y(), 0, "y of link " + i);
    }
  }

  /** A tree falls asleep and wakes as others do. */
  @Test
  void aTreeSleepsAndWakes() {
    World<String> w = new World<>(new WorldDef());
    Body<String> last = null;
    for (int i = 0; i < 12; i++) {
      Body<String> b = box(w, 0, -.5 - i, .1, .5, i == 11 ? 300 : 1);
      w.createJoint(JointDef.revolute(last, b, 0, -i));
      last = b;
    }
    for (int i = 0; i < 120; i++) {
      w.step(DT);
    }
    assertTrue(!last.awake(), "it hangs still, and is awake");
    last.applyImpulse(300, 0);
    for (int i = 0; i < 20; i++) {
      w.step(DT);
    }
    assertTrue(last.awake() && last.x() > .1, "x=" + last.x());
    assertTrue(Sanity.widestGap(w) < .01, "gap=" + Sanity.widestGap(w));
  }
}
