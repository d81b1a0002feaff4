package carom.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Circle;
import carom.physics.geometry.Shape;
import carom.physics.threads.WorkerThreads;
import carom.physics.threads.Workers;
import carom.sim.scene.BenchmarkScenes;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneRun;
import carom.sim.scene.SceneWorld;
import carom.sim.scene.View;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A step that is shared by threads gives the bits of one that isn't. */
final class WorkersTest {
  private static final int STEPS = 40;

  /** Scenes in which every stage has enough to share. */
  private enum Busy {
    PYRAMID(BenchmarkScenes.pyramid(55)),
    PILE(BenchmarkScenes.pile(1200, 25, 16)),
    TUMBLER(BenchmarkScenes.tumbler(30)),
    SMASH(BenchmarkScenes.smash(60, 20)),
    GAS(BenchmarkScenes.gas(2000)),
    NET(BenchmarkScenes.jointGrid(40)),
    KINDS(kinds(30)),
    SLEEPY(BenchmarkScenes.pile(900, 25, 16).with(new WorldDef()));

    private final Scene scene;
    private String alone;

    Busy(Scene scene) {
      this.scene = scene;
    }

    /** Returns the hashes of a run on the calling thread alone, which is computed once. */
    String alone() {
      if (alone == null) {
        alone = run(null);
      }
      return alone;
    }

    /** Hash of every tenth state. */
    String run(Workers workers) {
      SceneRun run = scene.start();
      run.world().workers(workers);
      StringBuilder hashes = new StringBuilder();
      for (int i = 1; i <= STEPS; i++) {
        run.step();
        if (i % 10 == 0) {
          hashes.append(Long.toHexString(run.world().stateHash())).append(' ');
        }
      }
      return hashes.toString();
    }
  }

  /** A net of all kinds of joints, some of them to the world and to one body that turns. */
  private static Scene kinds(int n) {
    return new Scene("kinds", "a net of all kinds", new View(0, 0, n, n), s -> kinds(s, n))
        .with(new WorldDef().withSleeping(false));
  }

  private static <T> void kinds(SceneWorld<T> s, int n) {
    Shape disc = new Circle(0.4f);
    Filter apart = Filter.DEFAULT.withGroup(-1);
    BodyDef def = new BodyDef(BodyType.DYNAMIC).shape(disc, Material.DEFAULT, apart);
    Body<T> hub = s.body(new BodyDef(BodyType.KINEMATIC).shape(disc, Material.DEFAULT, apart));
    hub.setAngularVelocity(1);
    List<Body<T>> bodies = new ArrayList<>();
    for (int x = 0; x < n; x++) {
      for (int y = 0; y < n; y++) {
        Body<T> body = s.body(def.position(x + 1, -y));
        if (y > 0) {
          s.joint(kind((x + y) % 11, bodies.get(bodies.size() - 1), body, x + 1, 0.5f - y));
        } else {
          s.joint(kind(x % 8, x % 2 == 0 ? hub : null, body, x + 1, 0));
        }
        if (x > 0 && y % 2 == 0) {
          s.joint(kind((x + y / 2) % 11, bodies.get(bodies.size() - n), body, x + 0.5f, -y));
        }
        bodies.add(body);
      }
    }
  }

  private static <T> JointDef<T> kind(int which, Body<T> a, Body<T> b, float x, float y) {
    return switch (which) {
      case 0 -> JointDef.revolute(a, b, x, y).limits(-0.5f, 0.5f);
      case 1 -> JointDef.revolute(a, b, x, y).motor(2, 5).spring(3, 0.5f);
      case 2 -> JointDef.distance(a, b, x, y, b.x(), b.y());
      case 3 -> JointDef.rope(a, b, x, y, b.x(), b.y(), 0.8f);
      case 4 -> JointDef.prismatic(a, b, x, y, 0, 1).limits(-0.2f, 0.2f).motor(1, 3);
      case 5 -> JointDef.weld(a, b, x, y);
      case 6 -> JointDef.wheel(a, b, x, y, 0, 1).spring(4, 0.7f).motor(3, 2);
      case 7 -> JointDef.revolute(a, b, x, y);
      case 8 -> JointDef.motor(a, b, 200, 50);
      case 9 -> JointDef.gear(a, b, 2);
      default -> JointDef.rack(a, b, 1, 0, 0.5f);
    };
  }

  /** One thread that does the tasks in an order of its own, as many workers might. */
  private static final class Shuffled implements Workers {
    private final int count;
    private int runs;

    Shuffled(int count) {
      this.count = count;
    }

    @Override
    public int count() {
      return count;
    }

    @Override
    public void run(int tasks, Task task) {
      Scenes.Rng r = new Scenes.Rng(runs++);
      int[] order = new int[tasks];
      for (int i = 0; i < tasks; i++) {
        int j = r.below(i + 1);
        order[i] = order[j];
        order[j] = i;
      }
      for (int i : order) {
        task.run(i, r.below(count));
      }
    }
  }

  @ParameterizedTest
  @EnumSource(Busy.class)
  void anyOrderOfTheTasksGivesTheSameBits(Busy busy) {
    Shuffled two = new Shuffled(2);
    assertEquals(busy.alone(), busy.run(two));
    assertEquals(busy.alone(), busy.run(new Shuffled(7)));
    assertTrue(two.runs > STEPS, "nothing was shared");
  }

  @ParameterizedTest
  @EnumSource(Busy.class)
  void twoAndThreeThreadsGiveTheSameBits(Busy busy) {
    try (WorkerThreads two = new WorkerThreads(2);
        WorkerThreads three = new WorkerThreads(3)) {
      assertEquals(busy.alone(), busy.run(two));
      assertEquals(busy.alone(), busy.run(three));
    }
  }

  @ParameterizedTest
  @EnumSource(GoldenScenes.class)
  void goldenScenesGiveTheSameBits(GoldenScenes golden) {
    World<String> alone = golden.start();
    World<String> shared = golden.start();
    try (WorkerThreads workers = new WorkerThreads(2)) {
      shared.workers(workers);
      for (int i = 0; i < 100; i++) {
        golden.step(alone, i);
        golden.step(shared, i);
        if (i == 50) {
          WorldState state = shared.save(null);
          shared.restore(state);
        }
      }
      assertEquals(alone.stateHash(), shared.stateHash());
    }
  }

  @Test
  void smallWorldsAreSteppedByTheCallerAlone() {
    World<String> w = Scenes.stack(10);
    w.workers(
        new Workers() {
          @Override
          public int count() {
            return 2;
          }

          @Override
          public void run(int tasks, Task task) {
            throw new AssertionError("a world of ten boxes was shared");
          }
        });
    Scenes.steps(w, 30);
  }

  /** Threads are kept ready around the runs of each step, and only in large worlds. */
  @Test
  void stepsWorthSharingAreAnnounced() {
    StringBuilder heard = new StringBuilder();
    Workers workers =
        new Workers() {
          @Override
          public int count() {
            return 2;
          }

          @Override
          public void run(int tasks, Task task) {
            if (heard.charAt(heard.length() - 1) != 'r') {
              heard.append('r');
            }
            for (int i = 0; i < tasks; i++) {
              task.run(i, i % 2);
            }
          }

          @Override
          public void stepBegins() {
            heard.append('b');
          }

          @Override
          public void stepEnds() {
            heard.append('e');
          }
        };
    SceneRun run = BenchmarkScenes.pyramid(80).start();
    run.world().workers(workers);
    for (int i = 0; i < 3; i++) {
      run.step();
    }
    assertEquals("brebrebre", heard.toString());
    heard.setLength(0);
    World<String> small = Scenes.stack(10);
    small.workers(workers);
    Scenes.steps(small, 3);
    assertEquals(-1, heard.indexOf("b"));
  }

  @Test
  void whatAWorkerThrowsLeavesTheStep() {
    SceneRun run = Busy.PYRAMID.scene.start();
    IllegalStateException thrown = new IllegalStateException("as planned");
    run.world()
        .workers(
            new Workers() {
              @Override
              public int count() {
                return 2;
              }

              @Override
              public void run(int tasks, Task task) {
                throw thrown;
              }
            });
    assertSame(thrown, assertThrows(IllegalStateException.class, run::step));
  }

  @Test
  void workersMayComeAndGo() {
    SceneRun alone = Busy.PILE.scene.start();
    SceneRun shared = Busy.PILE.scene.start();
    try (WorkerThreads workers = new WorkerThreads(2)) {
      for (int i = 0; i < STEPS; i++) {
        shared.world().workers(i % 3 == 0 ? workers : null);
        alone.step();
        shared.step();
      }
    }
    assertEquals(alone.world().stateHash(), shared.world().stateHash());
  }

  @Test
  void callbacksStayOnTheCallingThread() {
    SceneRun run = Busy.PILE.scene.start();
    Thread me = Thread.currentThread();
    int[] heard = {0};
    run.world()
        .listener(
            new CollisionListener<>() {
              @Override
              public void postSolve(Collision<String> c) {
                assertSame(me, Thread.currentThread());
                heard[0]++;
              }
            });
    try (WorkerThreads workers = new WorkerThreads(2)) {
      run.world().workers(workers);
      for (int i = 0; i < STEPS; i++) {
        run.step();
      }
    }
    assertTrue(heard[0] > 0);
  }

  @Test
  void aSharedStepAllocatesNothing() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    SceneRun run = Busy.PYRAMID.scene.start();
    try (WorkerThreads workers = new WorkerThreads(2)) {
      run.world().workers(workers);
      for (int i = 0; i < 60; i++) {
        run.step();
      }
      long least = Long.MAX_VALUE;
      for (int attempt = 0; attempt < 58 && least > 200; attempt++) { // vectors until compiled
        long before = threads.getCurrentThreadAllocatedBytes();
        for (int i = 0; i < 30; i++) {
          run.step();
        }
        least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
      }
      assertTrue(least < 200, "bytes in 30 steps: " + least);
    }
  }
}
