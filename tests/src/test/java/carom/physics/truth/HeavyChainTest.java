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
import carom.physics.JointType;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.WorldState;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Chains and other trees of hinges, rods and welds that carry far more than their links weigh. What
 * welds alone do is in {@link HeavyBeamTest}.
 */
final class HeavyChainTest {
  private static final Material M = Material.DEFAULT;

  /** What joins two links of a chain. */
  private enum Link {
    HINGE,
    ROD,
    /** A rod whose limits are its length, not between centres. */
    LIMITED_ROD,
    /** A weld, but for the first one, which is a hinge: else nothing swings. */
    WELD,
    /** All of them in turn. */
    MIXED;

    private Link at(int i) {
      return this == MIXED ? values()[i % MIXED.ordinal()] : this == WELD && i == 0 ? HINGE : this;
    }
  }

  /** Joins a body with the next one of a chain, or with the world, where the links meet. */
  private static void join(
      World<String> w, Link link, Body<String> before, Body<String> next, double x, double y) {
    w.createJoint(joint(link.at(w.jointCount()), before, next, (float) x, (float) y));
  }

  private static JointDef<String> joint(
      Link link, Body<String> before, Body<String> next, float x, float y) {
    float fromX = before == null ? x : before.x();
    float fromY = before == null ? y : before.y();
    float wayX = next.x() - fromX;
    float wayY = next.y() - fromY;
    return switch (link) {
      case HINGE -> JointDef.revolute(before, next, x, y);
      case WELD -> JointDef.weld(before, next, x, y);
      case ROD -> JointDef.distance(before, next, fromX, fromY, next.x(), next.y());
      case LIMITED_ROD -> {
        float length = .75f * (float) Math.hypot(wayX, wayY);
        float partX = fromX + .25f * wayX;
        float partY = fromY + .25f * wayY;
        yield JointDef.distance(before, next, partX, partY, next.x(), next.y())
            .limits(length, length);
      }
      case MIXED -> throw new AssertionError();
    };
  }

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
    return levelChain(w, Link.HINGE, links, ratio);
  }

  private static List<Body<String>> levelChain(
      World<String> w, Link link, int links, double ratio) {
    List<Body<String>> chain = new ArrayList<>();
    for (int i = 0; i < links; i++) {
      Body<String> b = box(w, i + .5, 0, .5, .1, i == links - 1 ? ratio : 1);
      join(w, link, i == 0 ? null : chain.get(i - 1), b, i, 0);
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
    "HINGE,30,1000,31",
    "HINGE,100,100,101",
    "HINGE,5,300,4.55",
    "HINGE,10,100,9.6",
    "HINGE,10,1000,9.6",
    "HINGE,10,10000,9.6",
    "HINGE,20,50,19.7",
    "HINGE,30,100,29.6",
    "HINGE,60,300,59.7",
    "HINGE,120,1,119.7",
    "HINGE,200,50,199.7",
    "ROD,30,1000,31",
    "ROD,100,100,101",
    "ROD,5,300,4.55",
    "ROD,10,100,9.6",
    "ROD,10,1000,9.6",
    "ROD,10,10000,9.6",
    "ROD,20,50,19.7",
    "ROD,30,100,29.6",
    "ROD,60,300,59.7",
    "ROD,120,1,119.7",
    "ROD,200,50,199.7",
    "LIMITED_ROD,30,1000,31",
    "LIMITED_ROD,100,100,101",
    "LIMITED_ROD,5,300,4.55",
    "LIMITED_ROD,10,100,9.6",
    "LIMITED_ROD,10,1000,9.6",
    "LIMITED_ROD,10,10000,9.6",
    "LIMITED_ROD,20,50,19.7",
    "LIMITED_ROD,30,100,29.6",
    "LIMITED_ROD,60,300,59.7",
    "LIMITED_ROD,120,1,119.7",
    "LIMITED_ROD,200,50,199.7",
    "WELD,30,1000,31",
    "WELD,100,100,101",
    "WELD,5,300,4.55",
    "WELD,10,100,9.6",
    "WELD,10,1000,9.6",
    "WELD,10,10000,9.6",
    "WELD,20,50,19.7",
    "WELD,30,100,29.6",
    "WELD,60,300,59.7",
    "WELD,120,1,119.7",
    "WELD,200,50,199.7",
    "MIXED,30,1000,31",
    "MIXED,100,100,101",
    "MIXED,5,300,4.55",
    "MIXED,10,100,9.6",
    "MIXED,10,1000,9.6",
    "MIXED,10,10000,9.6",
    "MIXED,20,50,19.7",
    "MIXED,30,100,29.6",
    "MIXED,60,300,59.7",
    "MIXED,120,1,119.7",
    "MIXED,200,50,199.7",
    "ROD,10,100000,9.6"
  })
  void theEndStaysWithinReach(Link link, int links, double ratio, double reach) {
    World<String> w = awake();
    List<Body<String>> chain = levelChain(w, link, links, ratio);
    Body<String> end = chain.get(links - 1);
    double before = energy(w);
    double farthest = 0;
    double most = 0;
    double lowest = 0;
    for (int i = 0; i < 600; i++) {
      w.step(DT);
      farthest = Math.max(farthest, Math.hypot(end.x(), end.y()));
      most = Math.max(most, energy(w) - before);
      lowest = Math.min(lowest, end.y());
    }
    assertTrue(farthest <= reach, "farthest=" + farthest);
    double drop = (ratio + links / 2.0) * Lab.G * links;
    assertTrue(most < .003 * drop, "energy grew by " + most + " of " + drop);
    assertTrue(lowest < -.8 * links, "it doesn't swing: lowest=" + lowest);
    assertTrue(end.y() < (link == Link.HINGE ? 0 : .5), "it rises: y=" + end.y());
  }

  @ParameterizedTest
  @CsvSource({
    "HINGE,30,1000",
    "HINGE,100,100",
    "HINGE,10,100000",
    "HINGE,300,1",
    "ROD,30,1000",
    "ROD,100,100",
    "ROD,10,100000",
    "ROD,300,1",
    "LIMITED_ROD,30,1000",
    "WELD,30,1000",
    "WELD,100,100",
    "WELD,10,100000",
    "WELD,300,1",
    "MIXED,30,1000",
    "MIXED,100,100"
  })
  void aHangingLoadHangsStill(Link link, int links, double ratio) {
    World<String> w = awake();
    Body<String> last = null;
    for (int i = 0; i < links; i++) {
      Body<String> b = box(w, 0, -.5 - i, .1, .5, i == links - 1 ? ratio : 1);
      join(w, link, last, b, 0, -i);
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
  private static World<String> mobile(WorldDef def, Link link, int balls) {
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
        if (i % 2 == 0) {
          w.createJoint(JointDef.revolute(last, b, (float) x, -7 - i).limits(-.6f, .6f));
        } else {
          join(w, link, last, b, x, -7 - i);
        }
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

  @ParameterizedTest
  @EnumSource
  void aTreeWithLimitsAndContactsHolds(Link link) {
    World<String> w = mobile(new WorldDef().withSleeping(false), link, 80);
    double widest = 0;
    for (int i = 0; i < 1200; i++) {
      w.step(DT);
      widest = Math.max(widest, worstError(w));
    }
    assertTrue(widest < .05, "gap=" + widest);
  }

  /** A tree is no state: a world that was read, or restored, or has threads, goes on alike. */
  @ParameterizedTest
  @EnumSource
  void aTreeGoesOnToTheBitAfterRestoreAndWithThreads(Link link) {
    World<String> one = mobile(new WorldDef(), link, 600);
    World<String> two = mobile(new WorldDef(), link, 600);
    Lab.assertGoesOnToTheBit(one, two, 100, 300);
  }

  /** Returns by how much the worst joint fails: gap or error of length, m, or of an angle, rad. */
  private static double worstError(World<String> w) {
    double worst = 0;
    for (int i = 0; i < w.jointCount(); i++) {
      Joint<String> j = w.joint(i);
      double apart = Math.hypot(j.anchorBX() - j.anchorAX(), j.anchorBY() - j.anchorAY());
      if (j.type() == JointType.DISTANCE) {
        apart = Math.abs(apart - (j.isLimited() ? j.lower() : j.rest()));
      }
      double turned = j.type() == JointType.WELD ? Math.abs(j.angle()) : 0;
      worst = Math.max(worst, Math.max(apart, turned));
    }
    return worst;
  }

  /** A rod between links that are joined already is solved beside the chain, which stays a tree. */
  @Test
  void aRodThatClosesACycleLeavesTheChainWhole() {
    World<String> w = awake();
    List<Body<String>> chain = levelChain(w, 30, 1000);
    for (int i = 4; i < 24; i += 5) {
      Body<String> one = chain.get(i);
      Body<String> two = chain.get(i + 2);
      w.createJoint(JointDef.distance(one, two, one.x(), .1f, two.x(), -.1f));
    }
    double farthest = 0;
    for (int i = 0; i < 600; i++) {
      w.step(DT);
      farthest = Math.max(farthest, Math.hypot(chain.get(29).x(), chain.get(29).y()));
    }
    assertTrue(farthest < 31, "farthest=" + farthest);
    assertTrue(worstError(w) < .05, "worst=" + worstError(w));
    assertTrue(chain.get(29).y() < 0, "it doesn't swing: y=" + chain.get(29).y());
  }

  /** A net of hinges has cycles and is no tree; rods that hang on it are one still. */
  @Test
  void rodsOnANetAreATree() {
    World<String> w = awake();
    Body<String> one = box(w, 0, -.5, .1, .5, 2000);
    Body<String> two = box(w, 1, -.5, .1, .5, 2000);
    w.createJoint(JointDef.revolute(null, one, 0, 0));
    w.createJoint(JointDef.revolute(null, two, 1, 0));
    w.createJoint(JointDef.revolute(one, two, .5f, -.2f));
    w.createJoint(JointDef.revolute(one, two, .5f, -.8f));
    Body<String> last = two;
    for (int i = 0; i < 10; i++) {
      Body<String> b = box(w, 1, -2 - i, .1, .3, i % 9 == 0 ? 1000 : 1);
      w.createJoint(JointDef.distance(last, b, 1, -1 - i, 1, -2 - i));
      last = b;
    }
    last.setVelocity(3, 0);
    double worst = 0;
    for (int i = 0; i < 300; i++) {
      w.step(DT);
      worst = Math.max(worst, worstError(w));
    }
    assertTrue(worst < .02, "worst=" + worst);
  }

  /** A rod with room between its limits is none, at once; and one that is wound in is one. */
  @Test
  void whatARodIsMayChange() {
    World<String> w = awake();
    Body<String> last = null;
    for (int i = 0; i < 10; i++) {
      Body<String> b = box(w, 0, -1 - i, .1, .3, i == 9 ? 300 : 1);
      w.createJoint(JointDef.distance(last, b, 0, -i, 0, -1 - i));
      last = b;
    }
    for (int i = 0; i < 30; i++) {
      w.step(DT);
    }
    Joint<String> middle = w.joint(5);
    assertTrue(worstError(w) < .001, "worst=" + worstError(w));
    middle.setLimits(.5f, 1.5f);
    for (int i = 0; i < 10; i++) {
      w.step(DT);
    }
    assertEquals(-10 - .5 * Lab.G * 100 * DT * DT, last.y(), .02, "it falls freely");
    for (int i = 0; i < 60; i++) {
      w.step(DT);
    }
    for (int i = 0; i <= 120; i++) {
      float length = 1.5f - i / 120f;
      middle.setLimits(length, length);
      w.step(DT);
    }
    for (int i = 0; i < 10; i++) {
      w.step(DT);
    }
    assertEquals(.5, middle.coordinate(), .01);
    assertEquals(-9.5, last.y(), .1);
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

  @ParameterizedTest
  @EnumSource
  void aJointOfATreeBreaksUnderItsLoad(Link link) {
    World<String> w = awake();
    List<Body<String>> chain = new ArrayList<>();
    for (int i = 0; i < 10; i++) {
      Body<String> b = box(w, 0, -.5 - i, .1, .5, i == 9 ? 200 : 1);
      JointDef<String> joint = joint(link.at(i), i == 0 ? null : chain.get(i - 1), b, 0, -i);
      w.createJoint(i == 4 ? joint.breaksAt(1800, Float.POSITIVE_INFINITY) : joint);
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
  @ParameterizedTest
  @EnumSource
  void aTreeSleepsAndWakes(Link link) {
    World<String> w = new World<>(new WorldDef());
    Body<String> last = null;
    for (int i = 0; i < 12; i++) {
      Body<String> b = box(w, 0, -.5 - i, .1, .5, i == 11 ? 300 : 1);
      join(w, link, last, b, 0, -i);
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
    double gap = worstError(w);
    assertTrue(gap < .01, "gap=" + gap);
  }
}
