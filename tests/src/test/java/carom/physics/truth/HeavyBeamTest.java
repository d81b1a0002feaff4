package carom.physics.truth;

import static carom.physics.truth.Lab.DT;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.MotionLocks;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.WorldState;
import carom.physics.geometry.Box;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Shape;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Beams of welds that carry far more than their pieces weigh: rigid, so nothing sags. */
final class HeavyBeamTest {
  private static World<String> awake() {
    return new World<>(new WorldDef().withSleeping(false));
  }

  private static Body<String> piece(World<String> w, double x, double y, double mass) {
    Material m = Material.DEFAULT.withDensity((float) (mass / .2));
    BodyDef def = new BodyDef(BodyType.DYNAMIC).shape(new Box(.5f, .1f), m);
    return w.createBody(def.position((float) x, (float) y), "piece");
  }

  /** Pieces of a metre and a kilogram from the origin to the right; the last one is heavier. */
  private static List<Body<String>> cantilever(World<String> w, int pieces, double ratio) {
    List<Body<String>> beam = new ArrayList<>();
    for (int i = 0; i < pieces; i++) {
      Body<String> b = piece(w, i + .5, 0, i == pieces - 1 ? ratio : 1);
      w.createJoint(JointDef.weld(i == 0 ? null : beam.get(i - 1), b, i, 0));
      beam.add(b);
    }
    return beam;
  }

  private static void run(World<String> w, int ticks) {
    for (int i = 0; i < ticks; i++) {
      w.step(DT);
    }
  }

  /** A rigid beam bends by nothing, and its foot carries the weight times the lever. */
  @ParameterizedTest
  @CsvSource({
    "30,1000",
    "100,100",
    "10,10000",
    "10,100000",
    "5,300",
    "3,40",
    "30,1",
    "10,1",
    "300,1"
  })
  void aCantileverKeepsItsShape(int pieces, double ratio) {
    World<String> w = awake();
    List<Body<String>> beam = cantilever(w, pieces, ratio);
    double lowest = 0;
    double farthest = 0;
    for (int i = 0; i < 600; i++) {
      w.step(DT);
      Body<String> end = beam.get(pieces - 1);
      lowest = Math.min(lowest, end.y());
      farthest = Math.max(farthest, Math.hypot(end.x(), end.y()));
    }
    assertEquals(0, lowest, 1e-4 * pieces, "sag of the end");
    assertEquals(pieces - .5, farthest, 1e-4 * pieces, "reach");
    Joint<String> foot = w.joint(0);
    double weight = (ratio + pieces - 1) * Lab.G;
    double moment = Lab.G * (ratio * (pieces - .5) + (pieces - 1) * (pieces - 1) / 2.0);
    assertEquals(weight, foot.forceY(), 1e-3 * weight);
    assertEquals(moment, foot.torque(), 1e-3 * moment);
  }

  /** Welded pieces on a hinge swing as one body of their shape does. */
  @ParameterizedTest
  @ValueSource(ints = {1, 50})
  void aWeldedPendulumSwingsAsOneBody(int ratio) {
    int pieces = 12;
    World<String> w = awake();
    Body<String> last = null;
    for (int i = 0; i < pieces; i++) {
      Body<String> b = piece(w, i + .5, 0, i == pieces - 1 ? ratio : 1);
      w.createJoint(i == 0 ? JointDef.revolute(null, b, 0, 0) : JointDef.weld(last, b, i, 0));
      last = b;
    }
    World<String> single = awake();
    Shape rod = Compound.of(new Box(pieces / 2f, .1f, pieces / 2f, 0));
    Body<String> one =
        single.createBody(new BodyDef(BodyType.DYNAMIC).shape(rod).position(0, 0), "one");
    double mass = ratio + pieces - 1;
    double centre = ((pieces - 1) * (pieces - 1) / 2.0 + ratio * (pieces - .5)) / mass;
    double inertia = 0;
    for (int i = 0; i < pieces; i++) {
      double m = i == pieces - 1 ? ratio : 1;
      inertia += m * ((1 + .04) / 12 + (i + .5 - centre) * (i + .5 - centre));
    }
    one.setMass((float) mass, (float) inertia, (float) centre, 0);
    single.createJoint(JointDef.revolute(null, one, 0, 0));
    for (int i = 0; i < 300; i++) {
      w.step(DT);
      single.step(DT);
      assertEquals(one.angle(), last.angle(), .01, "tick " + i);
    }
    assertTrue(Math.abs(one.angularVelocity()) > .05, "it swings");
  }

  /** A beam on two rocks is held more often than needed, and holds all the same. */
  @Test
  void aBeamBetweenTwoRocksHoldsALoad() {
    World<String> w = awake();
    List<Body<String>> beam = cantilever(w, 30, 1);
    Body<String> rock = w.createBody(new BodyDef().position(30, 0), "rock");
    w.createJoint(JointDef.weld(beam.get(29), rock, 30, 0));
    Body<String> load = piece(w, 15.5, -.2, 500);
    w.createJoint(JointDef.weld(beam.get(15), load, 15.5f, -.1f));
    run(w, 600);
    assertEquals(-.2, load.y(), .01);
    assertEquals(0, load.angle(), .01);
    double carried = w.joint(0).forceY() - w.joint(30).forceY();
    assertEquals(530 * Lab.G, carried, .01 * 530 * Lab.G);
    double before = load.y();
    run(w, 600);
    assertEquals(before, load.y(), 1e-3, "it sinks");
  }

  /** No impulses hold a beam between rocks that move apart: it opens there, and stays calm. */
  @ParameterizedTest
  @CsvSource({".2,0,0", "0,.5,0", "0,0,1", ".1,.1,.2"})
  void aBeamThatIsTornStaysCalm(float vx, float vy, float turn) {
    World<String> w = awake();
    List<Body<String>> beam = cantilever(w, 10, 1);
    Body<String> rock =
        w.createBody(new BodyDef(BodyType.KINEMATIC).shape(new Box(.1f, .1f)).position(10, 0), "");
    w.createJoint(JointDef.weld(beam.get(9), rock, 10, 0));
    rock.setVelocity(vx, vy);
    rock.setAngularVelocity(turn);
    for (int i = 0; i < 240; i++) {
      if (i == 120) {
        rock.setVelocity(0, 0);
        rock.setAngularVelocity(0);
      }
      w.step(DT);
      assertTrue(Lab.kinetic(w) < 20, "tick " + i + " energy=" + Lab.kinetic(w));
    }
    assertTrue(Lab.kinetic(w) < .01, "energy=" + Lab.kinetic(w));
  }

  /** Boxes that fall on a beam of light pieces come to rest on it, and it doesn't bend. */
  @ParameterizedTest
  @CsvSource({"1,false", "10,false", "100,false", "1,true", "10,true"})
  void boxesRestOnABeam(int mass, boolean bridge) {
    World<String> w = new World<>(new WorldDef());
    List<Body<String>> beam = cantilever(w, 10, 1);
    if (bridge) {
      w.createJoint(JointDef.weld(null, beam.get(9), 10, 0));
    }
    List<Body<String>> boxes = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      Material m = Material.DEFAULT.withDensity(mass / .64f);
      BodyDef def = new BodyDef(BodyType.DYNAMIC).shape(new Box(.4f, .4f), m);
      boxes.add(w.createBody(def.position(5 + .05f * i, 1 + i), "box"));
    }
    double bent = 0;
    for (int i = 0; i < 600; i++) {
      w.step(DT);
      bent = Math.max(bent, Math.abs(beam.get(9).angle()));
    }
    assertTrue(bent < .002, "bent=" + bent);
    for (int i = 0; i < 4; i++) {
      assertTrue(!boxes.get(i).awake(), "box " + i + " is awake");
      assertEquals(.5 + .8 * i, boxes.get(i).y(), .1, "box " + i);
    }
  }

  /** Free pieces that spin keep momentum, energy and shape. */
  @Test
  void aWeldedWheelSpinsOn() {
    World<String> w = new World<>(new WorldDef().withSleeping(false).withGravity(0, 0));
    Body<String> hub = piece(w, 0, 0, 1);
    for (int spoke = 0; spoke < 4; spoke++) {
      Body<String> last = hub;
      for (int i = 1; i <= 6; i++) {
        int x = spoke == 0 ? i : spoke == 1 ? -i : 0;
        int y = spoke == 2 ? i : spoke == 3 ? -i : 0;
        Body<String> b = piece(w, x, y, i == 6 ? 100 : 1);
        w.createJoint(JointDef.weld(last, b, x, y));
        last = b;
      }
    }
    w.forEachBody(
        b -> {
          b.setVelocity(-2 * b.y(), 2 * b.x());
          b.setAngularVelocity(2);
        });
    double before = Lab.kinetic(w);
    double turning = Lab.momentum(w)[2];
    run(w, 600);
    assertEquals(before, Lab.kinetic(w), .005 * before);
    assertEquals(turning, Lab.momentum(w)[2], .005 * turning);
    assertEquals(0, hub.x(), .02);
    for (int i = 0; i < w.jointCount(); i++) {
      Joint<String> j = w.joint(i);
      assertEquals(0, j.angle(), .001);
      assertEquals(0, Math.hypot(j.anchorBX() - j.anchorAX(), j.anchorBY() - j.anchorAY()), .01);
    }
  }

  /** A piece that doesn't turn, and one that moves along x only, are welded like others. */
  @Test
  void lockedPiecesHold() {
    World<String> w = awake();
    Body<String> rail = piece(w, 0, 0, 300);
    rail.setMotionLocks(new MotionLocks(false, true, false));
    List<Body<String>> beam = new ArrayList<>(List.of(rail));
    for (int i = 1; i < 12; i++) {
      Body<String> b = piece(w, i, 0, i == 11 ? 300 : 1);
      b.setFixedRotation(i == 4);
      w.createJoint(JointDef.weld(beam.get(i - 1), b, i - .5f, 0));
      beam.add(b);
    }
    rail.setVelocity(1, 0);
    run(w, 300);
    for (int i = 0; i < 12; i++) {
      assertEquals(0, beam.get(i).y(), .01, "piece " + i);
      assertEquals(0, beam.get(i).angle(), .001, "piece " + i);
    }
  }

  /** A weld that gets a spring is none at once; without it, it is stiff again. */
  @Test
  void aLoadedWeldThatGetsASpringGivesWay() {
    World<String> w = awake();
    List<Body<String>> beam = cantilever(w, 10, 300);
    Body<String> end = beam.get(9);
    run(w, 30);
    Joint<String> middle = w.joint(5);
    middle.setSpring(.5f, .5f);
    run(w, 20);
    double drop = middle.anchorAY() - middle.anchorBY();
    assertTrue(drop > .2, "the point gives way: drop=" + drop);
    middle.setSpring(0, 0);
    run(w, 120);
    assertEquals(0, end.y(), .01, "it is drawn together again");
    assertEquals(0, end.angle(), .001);
  }

  /** Whether there is a tree is no state: a world that is restored goes on to the bit. */
  @Test
  void aWeldThatChangesWhileSavedGoesOnToTheBit() {
    World<String> w = awake();
    List<Body<String>> beam = cantilever(w, 10, 300);
    run(w, 30);
    WorldState saved = w.save(null);
    long[] hashes = new long[60];
    for (int run = 0; run < 2; run++) {
      for (int i = 0; i < 60; i++) {
        if (i == 10) {
          w.joint(5).setSpring(2, .5f);
        }
        if (i == 30) {
          w.joint(5).setSpring(0, 0);
          beam.get(3).applyImpulse(0, 200);
        }
        w.step(DT);
        if (run == 0) {
          hashes[i] = w.stateHash();
        }
        assertEquals(hashes[i], w.stateHash(), "tick " + i);
      }
      w.restore(saved);
    }
  }

  /** Both parts of a beam that breaks keep their shape, and gain no energy. */
  @ParameterizedTest
  @CsvSource({"20,10,1", "20,15,1", "20,5,1", "20,10,20", "20,5,300", "30,2,1000"})
  void theRestOfABrokenBeamFliesNotApart(int pieces, int at, double ratio) {
    World<String> w = awake();
    List<Body<String>> beam = cantilever(w, pieces, ratio);
    run(w, 60);
    double height = beam.get(pieces - 1).y();
    w.destroyJoint(w.joint(at));
    for (int i = 1; i <= 30; i++) {
      w.step(DT);
      double fallen = .5 * Lab.G * i * DT * (i * DT + DT / 4);
      assertEquals(height - fallen, beam.get(pieces - 1).y(), .01, "end at tick " + i);
      assertEquals(-fallen, beam.get(at).y(), .01, "broken piece at tick " + i);
      assertEquals(0, beam.get(at - 1).y(), .001, "stump at tick " + i);
    }
  }

  @Test
  void aWeldBreaksUnderItsMoment() {
    for (float most : new float[] {40_000, 50_000}) {
      World<String> w = awake();
      List<Body<String>> beam = new ArrayList<>();
      for (int i = 0; i < 20; i++) {
        Body<String> b = piece(w, i + .5, 0, i == 19 ? 300 : 1);
        JointDef<String> weld = JointDef.weld(i == 0 ? null : beam.get(i - 1), b, i, 0);
        w.createJoint(i == 5 ? weld.breaksAt(Float.POSITIVE_INFINITY, most) : weld);
        beam.add(b);
      }
      run(w, 60);
      // 300 kg at 14.5 m and fourteen pieces at 7 m on average: 44,480 N m.
      assertEquals(most < 44_480 ? 19 : 20, w.jointCount());
      assertEquals(0, beam.get(4).y(), .001);
      assertEquals(most < 44_480, beam.get(19).y() < -3);
    }
  }
}
