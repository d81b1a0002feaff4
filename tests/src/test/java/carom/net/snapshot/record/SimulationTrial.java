package carom.net.snapshot.record;

import carom.net.codec.BitCoder;
import carom.net.codec.Quantizer;
import carom.net.snapshot.frame.Motion;
import carom.net.snapshot.frame.Predictor;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.sim.scene.SceneRun;
import carom.sim.scene.SceneState;
import carom.sim.scene.catalog.Scenes;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Would the simulation itself be a better predictor of snapshots? Run its {@code main}: it puts
 * what a client holds of a scene into the scene's world, computes it up to the present, and tells
 * what the differences to the truth take, beside today's {@link Predictor}. Each way of predicting
 * has a table of its own, counted over the scene itself, so that none is at an advantage.
 */
public final class SimulationTrial {
  private static final int[] AGES = {2, 6, 12};
  private static final int RUN_IN = 120;
  private static final int TICKS = 480;
  private static final int TICKS_APART = 12;

  private SimulationTrial() {}

  /** What is known of a body at the baseline. */
  private enum Known {
    /** Today: no simulation. */
    LINE,
    /**
     * All of the world's state, velocities and contacts included, but poses and velocities rounded.
     */
    STATE_AND_CONTACTS,
    /** Rounded poses and velocities; contacts begin anew. */
    STATE,
    /** Rounded poses of two snapshots; contacts begin anew. */
    POSES
  }

  /** Counts each node's bits. */
  private static final class Counting extends DeltaCodec {
    private final double[] seen = new double[2 * NODES];
    private double bits;
    private long deltas;
    private long exact;

    Counting() {
      super(60);
    }

    @Override
    int head(BitCoder c, int head, int symbol) {
      headSteps(head, symbol, this::step);
      return symbol;
    }

    @Override
    int symbol(BitCoder c, int tree, int symbol) {
      numberSteps(tree, symbol, this::step);
      return symbol;
    }

    private void step(int node, int bit) {
      seen[2 * node + bit]++;
    }

    @Override
    int plain(BitCoder c, int value, int count) {
      bits += count;
      return value;
    }

    double bitsPerDelta() {
      double sum = bits;
      for (int i = 0; i < seen.length; i += 2) {
        double all = seen[i] + seen[i + 1];
        sum += surprise(seen[i], all) + surprise(seen[i + 1], all);
      }
      return sum / deltas;
    }

    private static double surprise(double n, double all) {
      return n == 0 ? 0 : n * Math.log(all / n) / Math.log(2);
    }
  }

  /** Prints a line for each scene, age and way. */
  public static void main(String[] args) {
    for (String scene : List.of("plough", "plough_above", "churn", "mixer", "gas_1k")) {
      for (int age : AGES) {
        for (Known known : Known.values()) {
          run(scene, age, known);
        }
      }
    }
  }

  private static void run(String scene, int age, Known known) {
    SceneRun run = Scenes.get(scene).start();
    List<Body<String>> bodies = new ArrayList<>();
    run.world()
        .forEachBody(
            body -> {
              if (body.type() == BodyType.DYNAMIC) {
                bodies.add(body);
              }
            });
    Predictor line = new Predictor(60);
    line.gravity(run.world().gravityX(), run.world().gravityY());
    Counting counting = new Counting();
    run.steps(RUN_IN);
    Motion residual = new Motion();
    SceneState baseline = null;
    SceneState present = null;
    long nanos = 0;
    for (int tick = 0; tick < TICKS; tick += TICKS_APART) {
      List<Motion> before = motions(bodies);
      run.steps(2);
      List<Motion> old = motions(bodies);
      baseline = run.save(baseline);
      run.steps(age);
      List<Motion> now = motions(bodies);
      present = run.save(present);
      List<Motion> predicted = null;
      if (known != Known.LINE) {
        run.restore(baseline);
        if (known != Known.STATE_AND_CONTACTS) {
          dropContacts(run, bodies, old, before);
        }
        for (int i = 0; i < bodies.size(); i++) {
          put(bodies.get(i), old.get(i), before.get(i), known);
        }
        long begin = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        run.steps(age);
        nanos += ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - begin;
        predicted = motions(bodies);
        run.restore(present);
      }
      for (int i = 0; i < bodies.size(); i++) {
        if (same(old.get(i), now.get(i))) {
          continue;
        }
        int way = Predictor.GOES_ON;
        if (predicted == null) {
          way = line.way(old.get(i), now.get(i), age);
          residual.setResidual(line, old.get(i), now.get(i), way, age);
        } else {
          difference(now.get(i), predicted.get(i), residual);
        }
        counting.exact += residual.isZero() ? 1 : 0;
        counting.deltas++;
        counting.code(BitCoder.known(), age, old.get(i), way, residual);
      }
      run.steps(TICKS_APART - 2);
    }
    System.out.printf(
        Locale.ROOT,
        "%-13s age=%-2d %-18s deltas=%-6d bits=%5.1f exact=%4.1f%% us/tick=%.0f%n",
        scene,
        age,
        known,
        counting.deltas,
        counting.bitsPerDelta(),
        100.0 * counting.exact / counting.deltas,
        nanos / 1e3 / age / (TICKS / TICKS_APART));
  }

  private static List<Motion> motions(List<Body<String>> bodies) {
    List<Motion> motions = new ArrayList<>();
    for (Body<String> body : bodies) {
      Motion m = new Motion();
      m.x = Quantizer.position(body.x());
      m.y = Quantizer.position(body.y());
      m.angle = Quantizer.angle(body.angle()) & Quantizer.ANGLE_STEPS - 1;
      m.vx = Quantizer.velocity(body.velocityX());
      m.vy = Quantizer.velocity(body.velocityY());
      m.omega = Quantizer.omega(body.angularVelocity());
      motions.add(m);
    }
    return motions;
  }

  private static boolean same(Motion a, Motion b) {
    Motion d = new Motion();
    difference(a, b, d);
    return d.isZero();
  }

  private static void difference(Motion a, Motion b, Motion out) {
    out.x = a.x - b.x;
    out.y = a.y - b.y;
    out.angle = Quantizer.wrapAngle(a.angle - b.angle);
    out.vx = a.vx - b.vx;
    out.vy = a.vy - b.vy;
    out.omega = a.omega - b.omega;
  }

  private static boolean rests(Motion m, Motion before) {
    return same(m, before) && (m.vx | m.vy | m.omega) == 0;
  }

  /** Far away and apart for a moment, in which nothing else moves. */
  private static void dropContacts(
      SceneRun run, List<Body<String>> bodies, List<Motion> old, List<Motion> before) {
    for (int i = 0; i < bodies.size(); i++) {
      if (!rests(old.get(i), before.get(i))) {
        bodies.get(i).setPose(1_000 + 10 * (i % 40), 1_000 + 10 * (i / 40), 0);
      }
    }
    run.world().step(1e-5f);
  }

  /** Who rests stays as he is. */
  private static void put(Body<String> body, Motion m, Motion before, Known known) {
    if (rests(m, before)) {
      return;
    }
    float angle = m.angle * (float) (2 * Math.PI) / Quantizer.ANGLE_STEPS;
    float steps = Quantizer.POSITION_STEPS;
    body.setPose(m.x / steps, m.y / steps, angle);
    if (known == Known.POSES) {
      Motion d = new Motion();
      difference(m, before, d);
      body.setVelocity(30 * d.x / steps, 30 * d.y / steps);
      body.setAngularVelocity(30 * d.angle * (float) (2 * Math.PI) / Quantizer.ANGLE_STEPS);
    } else {
      body.setVelocity(
          m.vx / (float) Quantizer.VELOCITY_STEPS, m.vy / (float) Quantizer.VELOCITY_STEPS);
      body.setAngularVelocity(m.omega / (float) Quantizer.OMEGA_STEPS);
    }
  }
}
