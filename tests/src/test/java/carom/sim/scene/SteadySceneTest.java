package carom.sim.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.fixtures.Jvm;
import carom.fixtures.Slice;
import carom.physics.World;
import carom.suite.Needs;
import java.io.File;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * No step of any scene allocates once the scene is under way: 150 steps after 400 allocate 0 bytes,
 * each of them; with {@code -Dcarom.all=true} 300.
 *
 * <p>The scenes run in a process without the module of the vector kernels, because interpreted code
 * makes an object of every vector until the JIT compiler is done with it, and when that is depends
 * on the machine; {@link SteadyStepTest} steps the same scenes with vectors. A virtual machine
 * allocates a little by itself, as for a class that is loaded or a method that is compiled, at a
 * step that differs from run to run. The engine's own allocations don't: what it allocates in a
 * step, it allocates in that step of every run. So a scene is run anew if any bytes were seen, and
 * a step counts with the fewest bytes of its runs.
 */
@Needs("processes")
final class SteadySceneTest {
  private static final int WARM_UP = 400;
  private static final int STEPS = (int) Slice.of(150, 300);
  private static final int MOST_RUNS = 6;

  /** Scenes that go on getting bodies or particles, and the step from which they have them all. */
  private static final Map<String, Integer> FILLED_AT =
      Map.of(
          "arch", 610,
          "bridge", 1560, // its bodies are there from 1460 on; its contacts pass 512 at 1538
          "bullets", 1210,
          "conveyor", 2690,
          "filters", 1800,
          "galton", 3790,
          "pulleys", 620,
          "water_wheel", 1000);

  @Test
  void noStepAllocates() throws Exception {
    List<String> flags = List.of("-Xmx512m", "-Dcarom.all=" + Slice.WHOLE);
    Process child =
        new ProcessBuilder(Jvm.command(flags, SteadySceneTest.class))
            .redirectError(new File("/dev/null"))
            .start();
    String told = new String(child.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, child.waitFor(), told);
    assertEquals(scenes().map(s -> s.name() + ":\n").collect(Collectors.joining()), told);
  }

  /** Prints of each scene which of its steps allocate how much. */
  public static void main(String[] args) {
    scenes()
        .filter(scene -> args.length == 0 || List.of(args).contains(scene.name()))
        .forEach(scene -> System.out.println(scene.name() + ":" + allocations(scene)));
  }

  private static Stream<Scene> scenes() {
    return Stream.concat(SteadyStepTest.scenes(), SteadyStepTest.scenesThatMakeBodies());
  }

  private static String allocations(Scene scene) {
    long[] least = run(scene);
    for (int run = 1; run < MOST_RUNS && !told(least).isEmpty(); run++) {
      long[] again = run(scene);
      for (int i = 0; i < STEPS; i++) {
        least[i] = Math.min(least[i], again[i]);
      }
    }
    return told(least);
  }

  private static String told(long[] bytes) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < STEPS; i++) {
      if (bytes[i] != 0) {
        text.append(" +").append(i).append('=').append(bytes[i]);
      }
    }
    return text.toString();
  }

  /** Returns the bytes that each step allocates, without those of a scene that makes bodies. */
  private static long[] run(Scene scene) {
    var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    World<String> world = new World<>(scene.def());
    SceneWorld<String> stage = new SceneWorld<>(world);
    scene.build(stage);
    world.listener(stage.listener());
    float dt = 1f / scene.tickRate();
    int warmUp = FILLED_AT.getOrDefault(scene.name(), WARM_UP);
    long[] bytes = new long[STEPS];
    for (int tick = 0; tick < warmUp + STEPS; tick++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      stage.beforeStep(tick, dt);
      if (SteadyStepTest.makesBodies(scene)) {
        before = threads.getCurrentThreadAllocatedBytes();
      }
      world.step(dt);
      if (tick >= warmUp) {
        bytes[tick - warmUp] = threads.getCurrentThreadAllocatedBytes() - before;
      }
    }
    return bytes;
  }
}
