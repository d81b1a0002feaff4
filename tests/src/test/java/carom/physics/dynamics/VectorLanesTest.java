package carom.physics.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** Vectors give the bits of the scalar code; whether they are there depends on the JVM's flags. */
class VectorLanesTest {
  /** A heap of boxes and discs, with friction, bounces and moving surfaces; some resist rolling. */
  static final class Heap {
    private Heap() {}

    /** Prints the hash of the state after many steps. */
    public static void main(String[] args) {
      System.out.println(ContactLanes.find() != null ? "vectors" : "scalar");
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
      for (int tick = 0; tick < 400; tick++) {
        world.step(1 / 60f);
      }
      return Long.toHexString(world.stateHash());
    }
  }

  @Test
  void vectorsAndScalarsAgree() throws Exception {
    assumeTrue(ContactLanes.find() != null, "this JVM has no vectors of 8 floats");
    Path java = Path.of(System.getProperty("java.home"), "bin", "java");
    Process child =
        new ProcessBuilder(
                java.toString(), "-cp", System.getProperty("java.class.path"), Heap.class.getName())
            .redirectError(new File("/dev/null"))
            .start();
    String out = new String(child.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, child.waitFor());
    assertTrue(out.startsWith("scalar"), out);
    assertEquals(out.trim(), "scalar" + System.lineSeparator() + Heap.hash());
  }
}
