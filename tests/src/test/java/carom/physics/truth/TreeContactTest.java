package carom.physics.truth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Slice;
import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Contacts on bodies of joint trees: they feel the whole tree, and make no energy. */
final class TreeContactTest {
  /** Energy by the book: never above that of the start, and joints hold while bodies are struck. */
  @ParameterizedTest
  @EnumSource
  void contactsOnTreesMakeNoEnergy(TreeScenes scene) {
    TreeScenes.Result r = scene.run(600);
    assertTrue(r.gained <= .005 * r.dropped, scene.what + ": " + r);
    assertTrue(scene.isElastic() || r.rise <= .03 * r.dropped, scene.what + ": " + r);
    assertTrue(r.gap <= .25, scene.what + ": " + r);
    assertTrue(r.overlap <= .1, scene.what + ": " + r);
  }

  /** The same, wherever the edge is under a link: one place could be a lucky one. */
  @Test
  void noEdgeMakesEnergy() {
    for (int i = -40; i <= 40; i += (int) Slice.of(2, 1)) {
      double edge = 6 + i * .0123;
      TreeScenes.Result r = TreeScenes.runEdgeAt(edge, 600);
      assertTrue(r.gained <= .005 * r.dropped && r.gap <= .25, "edge=" + edge + ": " + r);
    }
  }

  /** What stands on small welded pieces neither jumps nor trembles, nor bends. */
  @ParameterizedTest
  @EnumSource(names = {"DUMBBELL", "DUMBBELL_FLAT"})
  void aHeavyFreeBodyOfWeldsRests(TreeScenes scene) {
    TreeScenes.Result r = scene.run(600);
    assertTrue(r.jump <= .001 && r.gap <= .001 && r.kinetic <= 1e-3, r.toString());
  }

  /**
   * A disc hits a free bar of welded pieces, whose ends are heavy, without restitution: the impulse
   * is {@code v / (1/m + 1/M + r^2 / I)}, as for a rigid bar.
   */
  @ParameterizedTest
  @CsvSource({"50,3.5", "50,1.5", "1,2.5", "1000,5.5"})
  void aBlowFeelsTheWholeTree(double mass, double at) {
    World<String> w = Lab.space();
    int pieces = 8;
    List<Body<String>> bar = new ArrayList<>();
    double inertia = 0;
    for (int i = 0; i < pieces; i++) {
      double m = i == 0 || i == pieces - 1 ? 300 : 1;
      Material material = Lab.ICE.withDensity((float) (m / .2));
      Body<String> b = Lab.body(w, new Box(.5f, .1f), i + .5, 0, material);
      if (i > 0) {
        w.createJoint(JointDef.weld(bar.get(i - 1), b, i, 0));
      }
      bar.add(b);
      inertia += m * (1.04 / 12 + (i + .5 - pieces / 2.0) * (i + .5 - pieces / 2.0));
    }
    Body<String> disc = Lab.ball(w, at, .65, mass, Lab.ICE);
    disc.setVelocity(0, -3);
    double arm = at - pieces / 2.0;
    double impulse = 3 / (1 / mass + 1 / 606.0 + arm * arm / inertia);
    Lab.steps(w, 4);
    assertEquals(-3 + impulse / mass, disc.velocityY(), .03);
    double turning = -impulse * arm / inertia;
    for (Body<String> b : bar) {
      assertEquals(turning, b.angularVelocity(), .01 + .01 * Math.abs(turning));
    }
    assertEquals(-3 * mass, Lab.momentum(w)[1], 1e-3 * 3 * mass);
  }

  /** A heavy box without friction slides along a light plank on welded posts at its speed. */
  @Test
  void aHeavyBoxSlidesAlongAPlank() {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> plank = Lab.box(w, 10, 0, 10, .1, Lab.ICE.withDensity(.25f));
    for (int side = 0; side < 2; side++) {
      Body<String> post = Lab.box(w, .5 + 19 * side, -.6, .1, .5, Lab.ICE.withDensity(5));
      w.createJoint(JointDef.weld(plank, post, .5f + 19 * side, -.1f));
      w.createJoint(JointDef.weld(null, post, .5f + 19 * side, -1.1f));
    }
    Body<String> box = Lab.box(w, 2, .6, .5, .5, Lab.ICE.withDensity(300));
    box.setVelocity(3, 0);
    Lab.steps(w, 300);
    assertEquals(3, box.velocityX(), .01);
    assertEquals(17, box.x(), .05);
    assertEquals(.6, box.y(), .02);
  }

  /** Contacts of trees are no state either: threads and restoring change no bit. */
  @ParameterizedTest
  @EnumSource(names = {"EDGE", "EDGE_RODS", "BRIDGE", "DUMBBELL", "WALL_E"})
  void aStruckTreeGoesOnToTheBit(TreeScenes scene) {
    World<String> one = new World<>(new WorldDef());
    World<String> two = new World<>(new WorldDef());
    for (World<String> w : List.of(one, two)) {
      scene.build(w);
      for (int i = 0; i < 400; i++) {
        BodyDef ball = new BodyDef(BodyType.DYNAMIC).shape(new Circle(.3f), Material.DEFAULT);
        w.createBody(ball.position(i % 40 - 10, 4 + i / 40), "ball");
      }
    }
    Lab.assertGoesOnToTheBit(one, two, 80, 150);
  }
}
