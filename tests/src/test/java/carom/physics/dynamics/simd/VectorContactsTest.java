package carom.physics.dynamics.simd;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.dynamics.solver.ContactLanes;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.simd.VectorModule;
import carom.suite.Needs;
import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Vectors give the bits of the scalar code; whether they are there depends on the JVM's flags. */
@Needs("processes")
class VectorContactsTest {
  /**
   * A heap of boxes and discs, with friction, bounces and moving surfaces, some of which resist
   * rolling; and a hanging net of plain hinges with some motors, of which one corner is cut.
   */
  static final class Heap {
    private static final int WIDE = 20;

    private Heap() {}

    /** Prints the hash of the state after many steps. */
    public static void main(String[] args) {
      System.out.println(ContactLanes.FOUND != null ? "vectors" : "scalar");
      System.out.println(hash());
    }

    static String hash() {
      World<Object> world = new World<>(new WorldDef().withSleeping(false));
      world.createBody(new BodyDef().position(0, -1).shape(new Box(30, 1)), null);
      Material plain = new Material(1, .6f, 0);
      Material lively = new Material(1, .2f, .7f);
      for (int i = 0; i < 700; i++) {
        int column = i % 35;
        int row = i / 35;
        Material material = i % 11 == 0 ? lively : plain;
        BodyDef def =
            new BodyDef(BodyType.DYNAMIC)
                .position(column - 17 + .13f * (row % 3), .6f + 1.01f * row);
        if (i % 3 == 0) {
          def.shape(new Circle(.45f), i % 6 == 0 ? material : material.withRollingResistance(.1f));
        } else {
          def.shape(new Box(.45f, .45f), i % 7 == 0 ? material.withTangentSpeed(.5f) : material);
        }
        world.createBody(def, null);
      }
      Body<Object> corner = net(world);
      for (int tick = 0; tick < 400; tick++) {
        if (tick == 200) {
          corner.setPose(130, 50, 1);
        }
        world.step(1 / 60f);
      }
      return Long.toHexString(world.stateHash());
    }

    private static Body<Object> net(World<Object> world) {
      List<Body<Object>> knots = new ArrayList<>();
      for (int k = 0; k < WIDE * WIDE; k++) {
        int x = k % WIDE;
        int y = k / WIDE;
        boolean held = y == 0 && x % 6 == 0;
        BodyDef def = new BodyDef(held ? BodyType.STATIC : BodyType.DYNAMIC);
        def.position(100 + x, 80 - y)
            .shape(new Circle(.4f), new Material(1, .6f, 0), Filter.DEFAULT.withGroup(-1));
        knots.add(world.createBody(def, null));
        if (x > 0) {
          hinge(world, knots.get(k - 1), knots.get(k), 99.5f + x, 80f - y, k % 7 == 0);
        }
        if (y > 0) {
          hinge(world, knots.get(k - WIDE), knots.get(k), 100f + x, 80.5f - y, false);
        }
      }
      return knots.get(knots.size() - 1);
    }

    private static void hinge(
        World<Object> world, Body<Object> a, Body<Object> b, float x, float y, boolean driven) {
      JointDef<Object> def = JointDef.revolute(a, b, x, y);
      world.createJoint(driven ? def.motor(1, 5) : def);
    }
  }

  @Test
  void vectorsAndScalarsAgree() throws Exception {
    assumeTrue(ContactLanes.FOUND != null, "this JVM has no vectors of 8 floats");
    assertEquals("scalar" + System.lineSeparator() + Heap.hash(), child());
  }

  /** As on a processor without longer ones. */
  @Test
  void vectorsOfEightAndSixteenAgree() throws Exception {
    assumeTrue(ContactLanes.FOUND != null && VectorModule.LANES == 16, "no vectors of 16 floats");
    String[] flags = {
      "-XX:+IgnoreUnrecognizedVMOptions", "-XX:UseAVX=2", "--add-modules=jdk.incubator.vector"
    };
    assertEquals("vectors" + System.lineSeparator() + Heap.hash(), child(flags));
  }

  /** What a JVM with some flags says. */
  private static String child(String... flags) throws Exception {
    Path java = Path.of(System.getProperty("java.home"), "bin", "java");
    List<String> command = new ArrayList<>(List.of(java.toString()));
    command.addAll(List.of(flags));
    command.addAll(List.of("-cp", System.getProperty("java.class.path"), Heap.class.getName()));
    Process child = new ProcessBuilder(command).redirectError(new File("/dev/null")).start();
    String out = new String(child.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, child.waitFor());
    return out.trim();
  }
}
