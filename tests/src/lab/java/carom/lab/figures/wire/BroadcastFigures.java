package carom.lab.figures.wire;

import carom.lab.measure.Figure;
import carom.net.snapshot.Deltas;
import carom.net.snapshot.frame.FrameRing;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.sim.scene.BenchmarkScenes;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneRun;
import java.util.ArrayList;
import java.util.List;

/**
 * Measures bytes per client and tick: the whole world as Kryo objects beside a snapshot of all of
 * it, first in a gas of moving and colliding bodies, then with the same bodies at rest. Payload, 60
 * Hz, acks after 100 ms, everything in sight. Only the first frames use up the budget.
 */
public final class BroadcastFigures {
  private static final int[] BODIES = {10, 100, 1_000, 10_000};
  private static final int LAG = 6;
  private static final int WARM_UP = 120;
  private static final int BUDGET_BYTES = 24_000;

  private BroadcastFigures() {}

  /** Measures the figures, roughly if {@code quick}. */
  public static List<Figure> measure(boolean quick) {
    List<Figure> figures = new ArrayList<>();
    for (int bodies : BODIES) {
      figures.addAll(measure(bodies, quick ? 30 : 300));
    }
    return figures;
  }

  private static List<Figure> measure(int count, int ticks) {
    Scene scene = BenchmarkScenes.gas(count);
    SceneRun run = scene.start();
    List<Body<String>> bodies = new ArrayList<>();
    run.world()
        .forEachBody(
            body -> {
              if (body.type() == BodyType.DYNAMIC) {
                bodies.add(body);
              }
            });
    NaiveWorldBroadcast naive = new NaiveWorldBroadcast();
    FrameRing ring = new FrameRing(count);
    Client client =
        new Client(new Deltas(ring, scene.tickRate()), scene.tickRate(), true, LAG, BUDGET_BYTES);
    long naiveBytes = 0;
    long bytes = 0;
    for (int tick = 1; tick <= WARM_UP + ticks; tick++) {
      run.step();
      Frames.put(ring, tick, bodies);
      int sent = client.send();
      if (tick > WARM_UP) {
        naiveBytes += naive.bytes(tick, bodies);
        bytes += sent;
      }
    }
    long resting = 0;
    for (int tick = 1; tick <= WARM_UP + ticks; tick++) {
      Frames.put(ring, WARM_UP + ticks + tick, bodies); // the world stands still
      int sent = client.send();
      resting += tick > WARM_UP ? sent : 0;
    }
    return List.of(
        Figure.shown(count + " bodies: whole world by Kryo", 1.0 * naiveBytes / ticks, "B/tick"),
        Figure.shown(count + " bodies: ours, all of them moving", 1.0 * bytes / ticks, "B/tick")
            .withNote("%s times less", Figure.number(1.0 * naiveBytes / bytes)),
        Figure.shown(count + " bodies: ours, at rest", 1.0 * resting / ticks, "B/tick")
            .withNote("but for keep-alives"));
  }
}
