package carom.net.snapshot;

import carom.net.codec.BitCoder;
import carom.net.codec.RangeEncoder;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneRun;
import carom.sim.scene.Scenes;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Makes the text of {@link RecordPrior}: run its {@code main}. Runs scenes, codes the records that
 * a client with an older baseline would get, and counts what each node's bit was. Without arguments
 * it trains on all its scenes; then it also tells what records cost with the table in use.
 */
public final class PriorTraining {

  private static final List<String> SCENES =
      List.of("plough", "plough_above", "churn", "mixer", "bridge", "shapes", "wind", "orbits");
  private static final int[] AGES = {2, 3, 4, 6, 8, 12};
  private static final int TICKS = 600;

  private PriorTraining() {}

  /** Counts instead of coding. */
  private static final class Counting extends RecordCodec {
    final long[] ones = new long[NODES];
    final long[] all = new long[NODES];

    @Override
    int bit(BitCoder c, int node, int bit) {
      ones[node] += bit;
      all[node]++;
      return super.bit(c, node, bit);
    }
  }

  /** Prints the table. */
  public static void main(String[] args) {
    Counting counting = new Counting();
    for (String name : SCENES) {
      run(name, counting);
    }
    StringBuilder line = new StringBuilder();
    for (int node = 0; node < RecordCodec.NODES; node++) {
      double p = (counting.ones[node] + 0.4) / (counting.all[node] + 0.8);
      line.append(RecordPrior.letter(p));
      if (line.length() == 80 || node == RecordCodec.NODES - 1) {
        System.out.println("          + \"" + line + "\"");
        line.setLength(0);
      }
    }
  }

  private static void run(String name, Counting counting) {
    Scene scene = Scenes.get(name);
    SceneRun run = scene.start();
    List<Body<String>> bodies = new ArrayList<>();
    run.world()
        .forEachBody(
            body -> {
              if (body.type() != BodyType.STATIC) {
                bodies.add(body);
              }
            });
    FrameRing ring = new FrameRing(bodies.size());
    Predictor predictor = new Predictor(scene.tickRate());
    predictor.gravity(run.world().gravityX(), run.world().gravityY());
    RangeEncoder range = new RangeEncoder();
    byte[] out = new byte[1 << 20];
    Motion old = new Motion();
    Motion actual = new Motion();
    Motion residual = new Motion();
    long records = 0;
    long bytes = 0;
    for (int tick = 1; tick <= TICKS; tick++) {
      run.step();
      FrameState frame = ring.begin(tick);
      for (int i = 0; i < bodies.size(); i++) {
        Body<String> b = bodies.get(i);
        frame.put(
            i,
            1,
            1,
            -1,
            b.x(),
            b.y(),
            b.angle(),
            b.velocityX(),
            b.velocityY(),
            b.angularVelocity());
      }
      ring.end();
      int age = AGES[tick % AGES.length];
      if (tick <= age || tick % 2 != 0 && tick % 3 != 0) {
        continue;
      }
      FrameState baseline = ring.at(tick - age);
      range.reset(out, 0, out.length);
      counting.begin();
      int inDatagram = 0;
      for (int slot = 0; slot < bodies.size(); slot++) {
        if (frame.changedTick(slot) <= tick - age) {
          continue;
        }
        if (++inDatagram % 120 == 0) {
          counting.slot(range, RecordCodec.END);
          counting.begin();
        }
        baseline.motion(slot, old);
        frame.motion(slot, actual);
        int way = predictor.way(old, actual, age);
        residual.setResidual(predictor, old, actual, way, age);
        counting.slot(range, slot);
        counting.kind(range, RecordCodec.DELTA);
        counting.age(range, age);
        counting.way(range, old, way);
        counting.residual(range, old, residual);
        records++;
      }
      counting.slot(range, RecordCodec.END);
      bytes += range.finish();
    }
    System.err.printf(
        Locale.ROOT, "%-14s records=%d bits/record=%.2f%n", name, records, 8.0 * bytes / records);
  }
}
