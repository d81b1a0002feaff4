package carom.physics.collision;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.math.Transform;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Measures the time of one manifold, averaged over 256 pairs of shapes that nearly touch, turned
 * anyhow.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class ColliderBenchmark {
  private static final int PAIRS = 256;

  /** The shapes that meet. */
  @Param({"box-box", "upright-boxes", "circle-circle", "pentagon-circle", "pentagon-box"})
  public String shapes;

  private final Collider collider = new Collider();
  private final Manifold manifold = new Manifold();
  private final Transform[] posesA = new Transform[PAIRS];
  private final Transform[] posesB = new Transform[PAIRS];
  private Convex shapeA;
  private Convex shapeB;

  /** Places the pairs. */
  @Setup
  public void place() {
    Convex box = new Box(0.5f, 0.5f).parts().get(0);
    Convex circle = new Circle(0.5f).parts().get(0);
    Convex pentagon = Polygon.regular(5, 0.6f).parts().get(0);
    switch (shapes) {
      case "circle-circle" -> pair(circle, circle);
      case "pentagon-circle" -> pair(pentagon, circle);
      case "pentagon-box" -> pair(pentagon, box);
      default -> pair(box, box);
    }
    boolean turned = !shapes.equals("upright-boxes");
    for (int i = 0; i < PAIRS; i++) {
      double toB = 2 * Math.PI * i / PAIRS;
      float distance = 0.95f + 0.1f * i / PAIRS;
      posesA[i] = new Transform(0, 0, turned ? 0.7f * i : 0);
      float x = turned ? distance * (float) Math.cos(toB) : 0.2f;
      float y = turned ? distance * (float) Math.sin(toB) : distance;
      posesB[i] = new Transform(x, y, turned ? 1.1f * i : 0);
    }
  }

  private void pair(Convex a, Convex b) {
    shapeA = a;
    shapeB = b;
  }

  /** Collides all pairs. */
  @Benchmark
  @OperationsPerInvocation(PAIRS)
  public int collide() {
    int points = 0;
    for (int i = 0; i < PAIRS; i++) {
      collider.collide(shapeA, posesA[i], shapeB, posesB[i], 0.02f, manifold);
      points += manifold.count;
    }
    return points;
  }
}
