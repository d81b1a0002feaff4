package carom.lab.figures;

import carom.client.bots.Bot;
import carom.client.view.ClientView;
import carom.lab.measure.Figure;
import carom.net.codec.Quantizer;
import carom.net.snapshot.frame.FrameState;
import carom.net.transport.Impairment;
import carom.server.metrics.Counter;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/**
 * Measures the errors of the present that players in a busy arena see, and their causes. The
 * figures separate errors that a client could have avoided from those that it could not, because
 * another player's input was still on the way. Virtual time.
 */
final class FeelFigures {
  private static final int PLAYERS = 12;

  /**
   * Number of games. A single game is not enough: games differ by more than the effects measured.
   */
  private static final int GAMES = 6;

  private static final double BESIDE_METRES = 2.5;

  /** An entity farther off than this, m, was teleported in the meantime and doesn't count. */
  private static final double CUT_METRES = 5;

  /** An entity drawn at a player's present. It is compared when the server reaches that tick. */
  private record Look(int tick, int id, int generation, double x, double y, boolean own) {}

  private Stepper stepper;
  private final ArrayDeque<Look> looks = new ArrayDeque<>();
  private final List<Double> own = new ArrayList<>();
  private final List<Double> beside = new ArrayList<>();
  private final int[] lastTick = new int[PLAYERS];

  static List<Figure> measure(boolean quick) {
    return new FeelFigures().figures(quick ? 1 : GAMES, quick ? 3 : 15);
  }

  /** Plays a game. Its bots and losses have their own seeds. */
  private Sum play(int game, double seconds) {
    long seed = Stepper.SEED + 100_000L * game;
    Impairment line = Impairment.NONE.withLatency(50, 0).withLoss(2).withSeed(seed);
    for (int i = 0; i < PLAYERS; i++) {
      stepper.add("b" + i, line, new Bot(seed + i));
    }
    stepper.run(6);
    final Sum before = sum();
    final long endNs = stepper.nowNs() + (long) (seconds * 1e9);
    while (stepper.nowNs() < endNs) {
      stepper.step();
      for (int i = 0; i < PLAYERS; i++) {
        look(i, stepper.clients().get(i));
      }
      compare();
    }
    looks.clear();
    return sum().plus(before, -1);
  }

  private List<Figure> figures(int games, double seconds) {
    Sum sum = new Sum(0, 0, 0, 0, 0);
    double worst = 100;
    for (int game = 0; game < games; game++) {
      try (Stepper played = Stepper.of("arena")) {
        stepper = played;
        Arrays.fill(lastTick, 0);
        Sum one = play(game, seconds);
        worst = Math.min(worst, one.percent());
        sum = sum.plus(one, 1);
      }
    }
    double minutes = games * PLAYERS * seconds / 60;
    String where = "arena, 12 bots, 100 ms, 2 % loss: ";
    return List.of(
        Figure.atLeast(97, where + "bodies right when the server's state came", sum.percent(), "%")
            .withNote(
                "%d awake bodies of %d games, every bit, as computed last before that; worst game"
                    + " %.1f",
                sum.awake, games, worst),
        Figure.shown(where + "own body wrong then", sum.corrected / minutes, "/min")
            .withNote("a lost input of the own or of others, a difference that wasn't told yet"),
        Figure.shown(
                where + "differences that could not be predicted", sum.disagreed / minutes, "/min")
            .withNote("per player: the hash of what is near was another, with all inputs known"),
        Figure.shown(where + "present computed again", sum.rollbacks / minutes, "/min")
            .withNote("per player; by nature: others did something new while it was on the way"),
        picture(where + "own picture in the present against the truth, 95 %", own),
        picture(where + "picture of others beside it, 95 %", beside));
  }

  private static Figure picture(String what, List<Double> errors) {
    Collections.sort(errors);
    return Figure.shown(what, 100 * percentile(errors, 0.95), "cm")
        .withNote("%.1f cm for half of %d frames", 100 * percentile(errors, 0.5), errors.size());
  }

  private static double percentile(List<Double> sorted, double share) {
    return sorted.isEmpty() ? Double.NaN : sorted.get((int) (share * (sorted.size() - 1)));
  }

  private record Sum(long awake, long exact, long corrected, long rollbacks, long disagreed) {
    double percent() {
      return 100.0 * exact / awake;
    }

    Sum plus(Sum other, int times) {
      return new Sum(
          awake + times * other.awake,
          exact + times * other.exact,
          corrected + times * other.corrected,
          rollbacks + times * other.rollbacks,
          disagreed + times * other.disagreed);
    }
  }

  private Sum sum() {
    long awake = 0;
    long exact = 0;
    long corrected = 0;
    long rollbacks = 0;
    for (SimulatedClient client : stepper.clients()) {
      awake += client.stats().awakeBodies();
      exact += client.stats().exactBodies();
      corrected += client.stats().corrections();
      rollbacks += client.stats().rollbacks();
    }
    return new Sum(awake, exact, corrected, rollbacks, stepper.count(Counter.NEAR_DISAGREEMENTS));
  }

  /** Looks at the picture once a tick, because just then it shows the tick before. */
  private void look(int index, SimulatedClient client) {
    ClientView view = client.view();
    ClientView.Drawn me = view.own();
    if (view.tick() == lastTick[index] || me == null) {
      return;
    }
    lastTick[index] = view.tick();
    for (int i = 0; i < view.entityCount(); i++) {
      ClientView.Drawn d = view.entity(i);
      boolean near = Math.hypot(d.x() - me.x(), d.y() - me.y()) <= BESIDE_METRES;
      if (near && d.alpha() == 1) {
        looks.add(new Look(view.tick() - 1, d.id(), d.generation(), d.x(), d.y(), d == me));
      }
    }
  }

  private void compare() {
    int now = stepper.frame().tick();
    while (!looks.isEmpty() && looks.peek().tick <= now) {
      Look look = looks.poll();
      FrameState truth = stepper.frame(look.tick);
      if (truth == null
          || !truth.alive(look.id)
          || truth.generation(look.id) != look.generation
          || truth.still(look.id)) {
        continue;
      }
      double error =
          Math.hypot(
              Quantizer.positionOf(truth.x(look.id)) - look.x,
              Quantizer.positionOf(truth.y(look.id)) - look.y);
      if (error < CUT_METRES) {
        (look.own ? own : beside).add(error);
      }
    }
  }
}
