package carom.client;

import carom.client.link.Connection;
import carom.client.prediction.Agreement;
import carom.client.prediction.Prediction;
import carom.net.protocol.ClientMessage;
import carom.net.snapshot.exact.OwnState;
import carom.sim.near.Neighbourhood;
import java.util.ArrayList;
import java.util.List;

/**
 * Reports predictions that differ from the server without an explanation. The server, which knows
 * all inputs, decides whether there was an ordinary reason. One stay's; one thread; allocates only
 * when it reports.
 */
final class DivergenceReporter {
  private static final long GAP_NS = 2_000_000_000L;

  private final Prediction prediction;
  private final Connection connection;

  /** Last tick of an unbroken run of exact predictions of a lone own body, or -1. */
  private int exactTick = -1;

  private long reportedNs;

  /** Predictions up to this tick lacked something that the server had. */
  private int guessedTick = -1;

  DivergenceReporter(Prediction prediction, Connection connection) {
    this.prediction = prediction;
    this.connection = connection;
  }

  /** Takes note that predictions up to a tick lack something that the server has. */
  void guessed(int tick) {
    guessedTick = tick;
  }

  /**
   * Checks the last reconciliation.
   *
   * @param tick that was compared
   * @param wasAlone whether the own body was alone before the reconciliation
   */
  void check(int tick, boolean wasAlone, long nowNs) {
    if (tick <= guessedTick) {
      exactTick = -1;
      return;
    }
    checkOwn(tick, wasAlone && prediction.isAlone(), nowNs);
    checkNear(tick, nowNs);
  }

  /**
   * Checks the own body. Alone among statics, a prediction that follows an exact one must be exact.
   */
  private void checkOwn(int tick, boolean alone, long nowNs) {
    if (!prediction.result().compared() || !alone) {
      exactTick = -1;
    } else if (prediction.result().exact() || prediction.result().told()) {
      exactTick = tick;
    } else if (exactTick >= 0) {
      if (isReportDue(nowNs)) {
        reportedNs = nowNs;
        OwnState wrong = prediction.result().predicted();
        List<Integer> body = new ArrayList<>();
        body.add(Neighbourhood.key(wrong.slot(), wrong.generation()));
        for (int i = 0; i < OwnState.FLOATS; i++) {
          body.add(wrong.bits(i));
        }
        List<Integer> words = new ArrayList<>();
        for (int i = 0; i < Math.min(wrong.words(), ClientMessage.Diverged.MAX_WORDS); i++) {
          words.add(wrong.word(i));
        }
        connection.send(new ClientMessage.Diverged(tick, exactTick, false, body, words));
      }
      exactTick = -1;
    }
  }

  /** Checks the predicted set. From equal hashes and real inputs it must be exact, too. */
  private void checkNear(int tick, long nowNs) {
    Agreement agreement = prediction.agreement();
    Neighbourhood state = agreement.divergedState();
    if (!agreement.hasDiverged() || state.count() < 2 || !isReportDue(nowNs)) {
      return;
    }
    reportedNs = nowNs;
    List<Integer> bodies = new ArrayList<>();
    for (int i = 0; i < Math.min(state.count(), ClientMessage.Diverged.MAX_BODIES); i++) {
      for (int j = 0; j < ClientMessage.Diverged.BODY_INTS; j++) {
        bodies.add(state.rows().bodies().get(i, j));
      }
    }
    connection.send(
        new ClientMessage.Diverged(tick, agreement.equalTick(), true, bodies, List.of()));
  }

  private boolean isReportDue(long nowNs) {
    return reportedNs == 0 || nowNs - reportedNs >= GAP_NS;
  }
}
