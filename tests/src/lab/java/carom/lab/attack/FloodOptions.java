package carom.lab.attack;

import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Option;

/** The flags of {@code attack --flood}. */
final class FloodOptions {
  @Option(
      names = "--flood-rates",
      paramLabel = "N",
      split = ",",
      description = "datagrams per second of strangers, a row for each, default 10000,30000,100000")
  private List<Integer> rates = new ArrayList<>(List.of(10_000, 30_000, 100_000));

  @Option(
      names = "--flood-players",
      paramLabel = "N",
      description = "players who flood at once, default ${DEFAULT-VALUE}; 0 = no such row")
  private int players = 4;

  @Option(
      names = "--flood-budgets",
      paramLabel = "N",
      description = "how many times the budget each of them sends, default ${DEFAULT-VALUE}")
  private int budgets = 20;

  @Option(
      names = "--flood-bots",
      paramLabel = "N",
      description = "honest bots that play, default ${DEFAULT-VALUE}")
  private int bots = 24;

  @Option(
      names = "--turn",
      paramLabel = "S",
      description = "seconds of each turn, default ${DEFAULT-VALUE}")
  private int turnS = 15;

  @Option(
      names = "--pairs",
      paramLabel = "N",
      description = "turns without and with each flood, default ${DEFAULT-VALUE}")
  private int pairs = 5;

  List<Integer> rates() {
    return rates;
  }

  int players() {
    return players;
  }

  int budgets() {
    return budgets;
  }

  int bots() {
    return bots;
  }

  int turnS() {
    return turnS;
  }

  int pairs() {
    return pairs;
  }
}
