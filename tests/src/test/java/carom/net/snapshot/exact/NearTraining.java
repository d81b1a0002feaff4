package carom.net.snapshot.exact;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.client.bots.Bot;
import carom.net.codec.BitCoder;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.transport.Impairment;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * Makes {@code near.txt} of {@link NearTables}: counts the symbols of near updates in games of bots
 * in virtual time. A {@code main}, run by hand when the rows' form changes.
 */
final class NearTraining {
  private static final String[] GAMES = {"arena", "platformer"};
  private static final int BOTS = 10;
  private static final double SECONDS = 20;

  /** Each symbol counts as seen so often before. */
  private static final double BEFORE = 0.15;

  /** Counts instead of coding. */
  private static final class Counting extends NearRowCodec {
    private final double[][] seen = new double[NearTables.LINES][NearTables.SYMBOLS];

    @Override
    int symbol(BitCoder c, NearTables.Row row, int context, int symbol) {
      seen[NearTables.line(row, context)][symbol]++;
      return symbol;
    }
  }

  private NearTraining() {}

  /** Writes the file. */
  public static void main(String[] args) throws IOException {
    double[][][] seen = new double[GAMES.length][][];
    for (int i = 0; i < GAMES.length; i++) {
      seen[i] = count(GAMES[i]);
    }
    StringBuilder text = new StringBuilder();
    for (int row = 0; row < NearTables.LINES; row++) {
      double[] shares = new double[NearTables.SYMBOLS];
      for (double[][] game : seen) {
        double all = BEFORE * NearTables.SYMBOLS;
        for (double n : game[row]) {
          all += n;
        }
        for (int s = 0; s < shares.length; s++) {
          shares[s] += (game[row][s] + BEFORE) / all / seen.length;
        }
      }
      for (double share : shares) {
        text.append(NearTables.letter(share));
      }
      text.append('\n');
    }
    Files.writeString(Path.of(args[0]), text);
  }

  private static double[][] count(String game) {
    Counting counting = new Counting();
    int[] last = new int[BOTS];
    long rows = 0;
    try (Stepper stepper = Stepper.of(game)) {
      for (int i = 0; i < BOTS; i++) {
        Impairment line = Impairment.NONE.withLatency(50, 0).withLoss(2).withSeed(Stepper.SEED + i);
        ClientConfig config = ClientConfig.of("b" + i).withPrediction(mode(i));
        stepper.add(config, line, new Bot(i));
      }
      stepper.run(3);
      for (long end = stepper.nowNs() + (long) (SECONDS * 1e9); stepper.nowNs() < end; ) {
        stepper.step();
        for (int i = 0; i < BOTS; i++) {
          SimulatedClient client = stepper.clients().get(i);
          SnapshotDecoder decoder = client.game().decoder();
          if (decoder.hasAck() && decoder.ackSequence() != last[i]) {
            last[i] = decoder.ackSequence();
            OwnState own = decoder.own();
            if (decoder.hasOwn() && own.near.updating) {
              counting.part(BitCoder.known(), own);
              rows += own.near.partRows();
            }
          }
        }
      }
    }
    System.out.printf(Locale.ROOT, "%s: rows=%d%n", game, rows);
    return counting.seen;
  }

  private static PredictionMode mode(int bot) {
    return bot % 2 == 0 ? PredictionMode.ISLAND : PredictionMode.ALL;
  }
}
