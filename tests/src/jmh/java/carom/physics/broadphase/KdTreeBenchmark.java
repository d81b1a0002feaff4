package carom.physics.broadphase;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Measures the work of a KD-tree per box, with 10,000 boxes and about 0.9 pairs per box. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class KdTreeBenchmark {
  private static final int BOXES = 10_000;

  private final AabbArray boxes = new AabbArray(BOXES);
  private final AabbArray others = new AabbArray(BOXES);
  private final int[] ids = new int[BOXES];
  private final KdTree tree = new KdTree(boxes);
  private final KdTree other = new KdTree(others);
  private long seed = 1;
  private float way = 0.05f;
  private int pairs;

  /** Scatters the boxes over a square, and others of another tree over the same. */
  @Setup
  public void scatter() {
    for (int id = 0; id < BOXES; id++) {
      ids[id] = id;
      put(boxes, id);
      put(others, id);
    }
    tree.rebuild(boxes, ids, BOXES);
    other.rebuild(others, ids, BOXES);
  }

  private void put(AabbArray into, int id) {
    float x = 150 * random();
    float y = 150 * random();
    float halfX = 0.25f + 0.5f * random();
    float halfY = 0.25f + 0.5f * random();
    into.set(id, x - halfX, y - halfY, x + halfX, y + halfY);
  }

  private float random() {
    seed = seed * 6364136223846793005L + 1442695040888963407L;
    return (seed >>> 40) * 0x1p-24f;
  }

  /** Moves every box by 5 cm, to and fro, and refits the tree. */
  @Benchmark
  @OperationsPerInvocation(BOXES)
  public void moveAndRefit() {
    way = -way;
    for (int id = 0; id < BOXES; id++) {
      float dx = (id & 1) == 0 ? way : -way;
      boxes.set(id, boxes.minX(id) + dx, boxes.minY(id), boxes.maxX(id) + dx, boxes.maxY(id));
    }
    tree.refit();
  }

  /** Rebuilds the tree. */
  @Benchmark
  @OperationsPerInvocation(BOXES)
  public void rebuild() {
    tree.rebuild(boxes, ids, BOXES);
  }

  /** Finds all overlapping pairs of the tree with itself. */
  @Benchmark
  @OperationsPerInvocation(BOXES)
  public int selfJoin() {
    pairs = 0;
    tree.pairs((a, b) -> pairs++);
    return pairs;
  }

  /** Finds all overlapping pairs of two trees. */
  @Benchmark
  @OperationsPerInvocation(BOXES)
  public int join() {
    pairs = 0;
    tree.join(other, (a, b) -> pairs++);
    return pairs;
  }
}
