package carom.physics.dynamics.solver;

import carom.physics.WorldDef;
import carom.physics.dynamics.Dynamics;
import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeSpec;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.domain.DomainPhases;
import carom.physics.dynamics.domain.SolverBodies;
import carom.physics.dynamics.jointtree.JointTrees;
import carom.physics.dynamics.store.ParallelFor;
import carom.physics.geometry.Box;
import carom.physics.geometry.Shape;
import carom.physics.settings.Settings;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Measures one pass of the contact solver over a pyramid of 55 rows, 1,540 boxes with 4,500
 * contacts of two points. With {@code -prof gc}: anything above a few bytes means that vectors are
 * boxed.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(value = 1, jvmArgsAppend = "--add-modules=jdk.incubator.vector")
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class ContactSolverBenchmark {
  private static final int ROWS = 55;
  private static final float DT = 1 / 60f;

  /** Name of the kernels: {@code vector} or {@code scalar}. */
  @Param({"vector", "scalar"})
  public String kernels;

  private final Settings settings =
      new WorldDef()
          .withContactHertz(30)
          .withSlop(0.005f)
          .withMaxSpeed(400)
          .withMaxAngularSpeed(100)
          .withJointDampingRatio(2)
          .withSleeping(false)
          .withContinuous(false);

  private final Dynamics world = new Dynamics(settings);
  private final ActiveBodies active = new ActiveBodies();
  private final SolverBodies bodies = new SolverBodies(active, null, new ParallelFor());
  private final DomainPhases phases = new DomainPhases();
  private final JointTrees noTrees = new JointTrees();
  private ContactSolver solver;

  /** Builds the pyramid and lets it settle. */
  @Setup
  public void build() {
    solver =
        new ContactSolver(
            kernels.equals("vector") ? ContactLanes.FOUND : null,
            new ParallelFor(),
            new ShapeTable(settings));
    add(BodyStore.STATIC, new Box(100, 1), 0, -1);
    Box box = new Box(0.5f, 0.5f);
    for (int row = 0; row < ROWS; row++) {
      for (int i = row; i < ROWS; i++) {
        add(BodyStore.DYNAMIC, box, i - row + 0.5f * (row - ROWS), row + 0.5f);
      }
    }
    for (int i = 0; i < 60; i++) {
      world.step(DT, null, null);
    }
    int count = world.bodies().count();
    active.reserve(count);
    for (int slot = 1; slot < count; slot++) { // the ground came first
      active.add(slot);
    }
    for (int i = 0; i < 400; i++) {
      prepare(); // the first steps of a process use the kernels sparingly
      applyBiasedImpulses();
      relax();
      warmStart();
    }
  }

  private void add(byte type, Shape shape, float x, float y) {
    ShapeSpec spec = new ShapeSpec(shape, 1, 0.6f, 0, 0, 0, 1, -1, 0, false, null, null);
    int body = world.editor().create(type, new ShapeSpec[] {spec}, null, false);
    world.bodies().setOriginPose(body, x, y, 1, 0);
    world.editor().enter(body, true);
  }

  /** Starts over, so that every iteration solves the same. */
  @Setup(Level.Iteration)
  public void begin() {
    prepare();
    bodies.integrateVelocities(phases, false);
    phases.run();
  }

  /** Collects, colours and packs the contacts. */
  @Benchmark
  public void prepare() {
    float h = DT / settings.substeps();
    bodies.begin(world.bodies(), settings, h, world.contacts());
    solver.prepare(world.contacts(), world.bodies(), bodies, noTrees, settings, h);
    bodies.load(phases);
    solver.pack(phases);
    phases.run();
  }

  /** Applies the impulses again. */
  @Benchmark
  public void warmStart() {
    solver.warmStart(phases);
    phases.run();
  }

  /** Runs the pass with bias. */
  @Benchmark
  public void applyBiasedImpulses() {
    solver.applyBiasedImpulses(phases);
    phases.run();
  }

  /** Runs the pass without bias, with friction. */
  @Benchmark
  public void relax() {
    solver.relax(phases);
    phases.run();
  }
}
