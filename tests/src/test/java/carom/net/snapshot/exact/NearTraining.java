package carom.net.snapshot.exact;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.client.bots.Bot;
import carom.fixtures.MachineGame;
import carom.net.codec.BitCoder;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;

/**
 * Makes {@code near.txt} of {@link NearTables}: counts the symbols of near updates in games of bots
 * in virtual time. A {@code main}, run by hand when the rows' form changes.
 */
final class NearTraining {
  private static final String[] GAMES = {"arena", "platformer", "machines"};
  private static final int BOTS = 10;
  private static final double SECONDS = 20;

  /** Each symbol counts as seen so often before. */
  private static final double BEFORE = 0.15;

  /** Counts instead of coding. */
  private static final class Counting extends NearRowCodec {
    private final double[][] seen = new double[NearTables.LINES][NearTables.SYMBOLS];

    @Override
    int symbol(BitCoder c, NearTables.Quantity row, int context, int symbol) {
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
        if (Arrays.stream(game[row]).sum() == 0) {
          continue; // a game without joints says nothing about them
        }
        for (double n : game[row]) {
          all += n;
        }
        for (int s = 0; s < shares.length; s++) {
          shares[s] += (game[row][s] + BEFORE) / all;
        }
      }
      double sum = Arrays.stream(shares).sum();
      for (double share : shares) {
        text.append(NearTables.letter(sum == 0 ? 1 : share / sum));
      }
      text.append('\n');
    }
    Files.writeString(Path.of(args[0]), text);
  }

  private static double[][] count(String game) {
    Counting counting = new Counting();
    int[] last = new int[BOTS];
    long rows = 0;
    int bots = isMachines(game) ? 2 : BOTS; // as many as have a place to start
    try (Stepper stepper = play(game)) {
      for (int i = 0; i < bots; i++) {
        Impairment line = Impairment.NONE.withLatency(50, 0).withLoss(2).withSeed(Stepper.SEED + i);
        ClientConfig config = ClientConfig.of("b" + i).with(ClientConfig.PREDICTION, mode(i));
        stepper.add(config, line, isMachines(game) ? Scripts.wander(Stepper.SEED + i) : new Bot(i));
      }
      stepper.run(3);
      for (long end = stepper.nowNs() + (long) (SECONDS * 1e9); stepper.nowNs() < end; ) {
        stepper.step();
        for (int i = 0; i < bots; i++) {
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

  private static boolean isMachines(String game) {
    return game.equals("machines");
  }

  private static Stepper play(String game) {
    if (!isMachines(game)) {
      return Stepper.of(game);
    }
    StringBuilder spawns = new StringBuilder();
    for (int i = 0; i < 6; i++) {
      int x = 8 * i - 20;
      spawns.append(", {\"name\": \"ragdoll\", \"at\": [" + x + ", 0.1]}");
      spawns.append(", {\"name\": \"crate\", \"at\": [" + (x + 3) + ", 8]}");
    }
    spawns.append(", {\"name\": \"bridge\", \"at\": [-12, 4], \"team\": 12}");
    spawns.append(", {\"name\": \"weak bridge\", \"at\": [12, 4], \"team\": 12}");
    spawns.append(", {\"name\": \"crane\", \"at\": [0, 6]}");
    return Stepper.of(MachineGame.level(spawns.toString()), ServerConfig.defaults());
  }

  private static PredictionMode mode(int bot) {
    return bot % 2 == 0 ? PredictionMode.ISLAND : PredictionMode.ALL;
  }
}
