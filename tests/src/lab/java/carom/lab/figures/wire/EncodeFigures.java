package carom.lab.figures.wire;

import carom.lab.measure.Figure;
import carom.net.snapshot.Deltas;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.sim.scene.SceneRun;
import carom.sim.scene.Scenes;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Measures the CPU time of one client's snapshot. 1,000 bodies are in sight, a part of which moves:
 * 600 as in {@code churn} and 400 as in {@code gas_1k}. There are 60 ticks and 30 snapshots a
 * second, acks come after 67 to 267 ms, and every change is sent. The time includes acks, selection
 * and encoding.
 */
public final class EncodeFigures {
  private static final int BODIES = 1_000;
  private static final int CHURNING = 600;
  private static final int CLIENTS = 200;
  private static final int TICK_RATE = 60;
  private static final int TICKS_PER_SEND = 2;
  private static final int RUN_IN = 120;

  /** Limit of the time: 200 clients at 30 Hz may take half a core. */
  private static final double REACH_US = 0.5e6 / 200 / 30;

  private EncodeFigures() {}

  /** Measures the figures, roughly if {@code quick}. */
  public static List<Figure> measure(boolean quick) {
    List<Figure> figures = new ArrayList<>();
    for (int percent : new int[] {10, 50, 100}) {
      measure(percent, quick ? 10 : 40); // compiles
      figures.add(measure(percent, quick ? 20 : 100));
    }
    return figures;
  }

  private static Figure measure(int percent, int sends) {
    SceneRun churn = Scenes.get("churn").start();
    SceneRun gas = Scenes.get("gas_1k").start();
    List<Body<String>> bodies = new ArrayList<>();
    add(churn, CHURNING, bodies);
    add(gas, BODIES, bodies);
    FrameRing ring = new FrameRing(BODIES);
    Deltas deltas = new Deltas(ring, TICK_RATE);
    Client[] clients = new Client[CLIENTS];
    for (int i = 0; i < CLIENTS; i++) {
      clients[i] = new Client(deltas, TICK_RATE, false, 2 + i % 7, Integer.MAX_VALUE);
    }
    churn.steps(RUN_IN);
    gas.steps(RUN_IN);
    ThreadMXBean clock = ManagementFactory.getThreadMXBean();
    double[] micros = new double[sends];
    long bytes = 0;
    int runIn = RUN_IN / 2;
    for (int send = -runIn; send < sends; send++) {
      for (int i = 0; i < TICKS_PER_SEND; i++) {
        churn.step();
        gas.step();
        int tick = (send + runIn) * TICKS_PER_SEND + i + 1;
        put(ring, tick, bodies, percent);
      }
      long begin = clock.getCurrentThreadCpuTime();
      long sent = 0;
      for (Client client : clients) {
        sent += client.send();
      }
      double took = (clock.getCurrentThreadCpuTime() - begin) / 1e3 / CLIENTS;
      if (send >= 0) {
        micros[send] = took;
        bytes += sent;
      }
    }
    Arrays.sort(micros);
    return Figure.atMost(
            REACH_US,
            "encode 1,000 bodies in sight, " + percent + " % moving, per client and send",
            micros[sends / 2],
            "us")
        .withNote(
            "median of %d sends to %d clients; %.0f B each; 200 clients at 30 Hz within half a"
                + " core are 83 us",
            sends, CLIENTS, 1.0 * bytes / sends / CLIENTS);
  }

  private static void add(SceneRun run, int upTo, List<Body<String>> bodies) {
    run.world()
        .forEachBody(
            body -> {
              if (body.type() == BodyType.DYNAMIC && bodies.size() < upTo) {
                bodies.add(body);
              }
            });
  }

  /** Captures a frame in which the moving bodies are spread evenly over the slots. */
  private static void put(FrameRing ring, int tick, List<Body<String>> bodies, int percent) {
    FrameState frame = ring.begin(tick);
    for (int i = 0; i < BODIES; i++) {
      if (i * 37 % 100 < percent) {
        Frames.put(frame, i, bodies.get(i));
      } else {
        frame.put(i, 1, 1, -1, i % 40, (float) Math.floor(i / 40.0), 0, 0, 0, 0);
      }
    }
    ring.end();
  }
}
