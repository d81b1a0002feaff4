package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.InputSource;
import carom.client.PredictionMode;
import carom.client.bots.Bot;
import carom.client.view.ClientView;
import carom.fixtures.Levels;
import carom.fixtures.Slice;
import carom.net.codec.Quantizer;
import carom.net.snapshot.frame.FrameState;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Goal: what is not predicted moves on the screen as it moved on the server, on any line. Method:
 * the real server and a client that predicts nothing, in virtual time; each frame's picture is
 * compared with the server's frames around the moment it shows.
 */
class PictureScenarioTest {
  private static final Impairment NONE = Impairment.NONE;
  private static final double FRAME_SECONDS = 1 / 60.0;

  /**
   * The lines; how far 95 % and all of the pictures may be from the truth, and how much another way
   * than in truth a picture may go from frame to frame, metres. Bounces within a tick cost some
   * centimetres on any line.
   */
  enum Line {
    CLEAN(NONE, 0.01, 0.1, 0.12),
    LOSS_2(NONE.withLoss(2), 0.01, 0.12, 0.12),
    LOSS_10(NONE.withLoss(10), 0.01, 0.3, 0.3),
    // Some bursts are longer than any delay: then a look is a guess, and bodies bounce meanwhile.
    BURSTS_30(NONE.withBursts(30, 10), 0.3, 3, 1.2),
    LATENCY_100_JITTER_30(NONE.withLatency(100, 30), 0.01, 0.12, 0.12),
    LATENCY_300(NONE.withLatency(300, 0), 0.01, 0.12, 0.12),
    REORDER(NONE.withLatency(30, 10).withReorder(20, 0), 0.01, 0.12, 0.12),
    DUPLICATES(NONE.withReorder(0, 20), 0.01, 0.1, 0.12),
    LINE_64_KBIT(NONE.withBandwidth(64).withLatency(30, 0), 0.02, 0.3, 0.3);

    private final Impairment down;
    private final double usual;
    private final double most;
    private final double mostInFrame;

    Line(Impairment down, double usual, double most, double mostInFrame) {
      this.down = down;
      this.usual = usual;
      this.most = most;
      this.mostInFrame = mostInFrame;
    }
  }

  @ParameterizedTest
  @EnumSource(Line.class)
  void othersMoveAsTheyDid(Line line) {
    try (Stepper stepper = Stepper.of("arena")) {
      for (int i = 0; i < 5; i++) {
        stepper.add("b" + i, NONE, new Bot(i));
      }
      SimulatedClient watcher = watcher(stepper, line.down.withSeed(Stepper.SEED));
      stepper.run(6);
      Watch watch = new Watch(stepper, watcher);
      double frames = Slice.of(300, 480);
      for (int frame = 0; frame < frames; frame++) {
        stepper.run(FRAME_SECONDS);
        watch.look();
      }
      String about = line + " " + watch;
      assertTrue(watch.looks > 2.1 * frames, about);
      assertTrue(watch.error(0.95) <= line.usual, about);
      assertTrue(watch.error(1) <= line.most, about);
      assertTrue(watch.inFrame(1) <= line.mostInFrame, about);
    }
  }

  private static SimulatedClient watcher(Stepper stepper, Impairment impairment) {
    SimulatedClient watcher =
        stepper.add(
            ClientConfig.of("watcher").with(ClientConfig.PREDICTION, PredictionMode.NONE),
            impairment,
            InputSource.IDLE);
    stepper.awaitPlaying(watcher);
    return watcher;
  }

  /** Compares pictures with the truth. */
  private static final class Watch {
    private final Stepper stepper;
    private final SimulatedClient client;
    private final double[] errors = new double[1 << 16];
    private final double[] inFrames = new double[1 << 16];
    private final Map<Integer, double[]> before = new HashMap<>();
    int looks;
    private int moves;

    Watch(Stepper stepper, SimulatedClient client) {
      this.stepper = stepper;
      this.client = client;
    }

    void look() {
      ClientView view = client.view();
      double moment = view.renderTick();
      int tick = (int) Math.floor(moment);
      FrameState from = stepper.frame(tick);
      FrameState to = stepper.frame(tick + 1);
      Map<Integer, double[]> now = new HashMap<>();
      for (int i = 0; from != null && to != null && i < view.entityCount(); i++) {
        ClientView.Drawn drawn = view.entity(i);
        int id = drawn.id();
        if (!isSame(from, to, id) || drawn.generation() != from.generation(id)) {
          continue;
        }
        FrameState past = stepper.frame(tick - 20);
        if (past == null || !isSame(past, to, id)) {
          continue; // a cut may come some ticks late, when its record was lost
        }
        double t = moment - tick;
        double x = Quantizer.positionOf(from.x(id)) * (1 - t) + Quantizer.positionOf(to.x(id)) * t;
        double y = Quantizer.positionOf(from.y(id)) * (1 - t) + Quantizer.positionOf(to.y(id)) * t;
        double ex = drawn.x() - x;
        double ey = drawn.y() - y;
        now.put(id << 8 | drawn.generation(), new double[] {ex, ey});
        boolean moving = !from.still(id) || ex != 0 || ey != 0;
        if (moving && drawn.alpha() == 1 && looks < errors.length) {
          errors[looks++] = Math.hypot(ex, ey);
          double[] old = before.get(id << 8 | drawn.generation());
          if (old != null) {
            inFrames[moves++] = Math.hypot(ex - old[0], ey - old[1]);
          }
        }
      }
      before.clear();
      before.putAll(now);
    }

    private static boolean isSame(FrameState from, FrameState to, int id) {
      return from.alive(id)
          && to.alive(id)
          && from.generation(id) == to.generation(id)
          && from.teleports(id) == to.teleports(id);
    }

    double error(double share) {
      return percentile(errors, looks, share);
    }

    double inFrame(double share) {
      return percentile(inFrames, moves, share);
    }

    private static double percentile(double[] values, int count, double share) {
      double[] sorted = Arrays.copyOf(values, count);
      Arrays.sort(sorted);
      return count == 0 ? 0 : sorted[(int) Math.min(count - 1, count * share)];
    }

    @Override
    public String toString() {
      return String.format(
          Locale.ROOT,
          "looks=%d error p50=%.4f p95=%.4f p99=%.4f max=%.4f m, in a frame p95=%.4f p99=%.4f"
              + " max=%.4f m, delay=%.0f ms",
          looks,
          error(0.5),
          error(0.95),
          error(0.99),
          error(1),
          inFrame(0.95),
          inFrame(0.99),
          inFrame(1),
          client.stats().interpolationDelayMs());
    }
  }

  @Test
  void aTeleportIsShownAsACut() {
    // Goal: never a place between, however short the way. Method: the server teleports the ball by
    // 0.8 m again and again, too little to be guessed from the speed; 10 % loss.
    try (Stepper stepper = Stepper.of(Levels.arenaWithBall(), ServerConfig.defaults())) {
      SimulatedClient watcher = watcher(stepper, NONE.withLoss(10).withSeed(Stepper.SEED));
      stepper.run(4);
      HostEntity ball = ball(stepper.room().simulation());
      int cuts = 0;
      boolean left = true;
      for (int i = 0; i < 10; i++) {
        left = !left;
        ball.teleport(left ? -0.4f : 0.4f, -2, 0);
        ball.body().setVelocity(0, 0);
        double last = watcher.view().find(ball.id()).x();
        for (int frame = 0; frame < 15; frame++) {
          stepper.run(FRAME_SECONDS);
          double x = watcher.view().find(ball.id()).x();
          if (i > 0) {
            assertEquals(0.4, Math.abs(x), 0.01, "teleport " + i + " frame " + frame);
          }
          cuts += Math.abs(x - last) > 0.5 ? 1 : 0;
          last = x;
        }
      }
      assertEquals(10, cuts, 1);
    }
  }

  private static HostEntity ball(SimulationHost s) {
    for (int id = 0; id < s.entityCapacity(); id++) {
      if (s.entity(id) != null && s.entity(id).archetype().name().startsWith("ball")) {
        return s.entity(id);
      }
    }
    throw new IllegalStateException("no ball");
  }
}
