package carom.testkit;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The result of testing a game, for people and as JSON. Immutable. */
public final class GameReport {
  /** Most causes of shifts that are shown of a run; JSON has all. */
  private static final int MOST_COSTS = 5;

  private final String game;
  private final String level;
  private final long seed;
  private final double seconds;
  private final List<NetworkRun> runs;
  private final double msPerTick;
  private final double bytesPerTick;
  private final List<String> broken = new ArrayList<>();

  GameReport(
      String game,
      String level,
      long seed,
      double seconds,
      List<NetworkRun> runs,
      Map<String, String> findings,
      Map<String, Integer> failures,
      List<String> others,
      double msPerTick,
      double bytesPerTick) {
    this.game = game;
    this.level = level;
    this.seed = seed;
    this.seconds = seconds;
    this.runs = List.copyOf(runs);
    this.msPerTick = msPerTick;
    this.bytesPerTick = bytesPerTick;
    failures.forEach((text, times) -> broken.add(text + ", " + times + " times"));
    broken.addAll(findings.values());
    broken.addAll(others);
    for (NetworkRun run : runs) {
      if (run.unexplained() > 0) {
        broken.add(
            "clients computed "
                + run.unexplained()
                + " times otherwise than the server from the same inputs ("
                + run.network()
                + ", players="
                + run.players()
                + "), first "
                + run.firstUnexplained()
                + "; input, forces and collision may use only what a client is told: fields,"
                + " contacts, the tick, the level");
        break;
      }
    }
  }

  /** Returns the rules that the game breaks, in words, with advice; empty if it breaks none. */
  public List<String> broken() {
    return broken;
  }

  /** Returns the mean corrections of a player's own body, per minute, over all runs. */
  public double correctionsPerMinute() {
    return runs.stream().mapToDouble(NetworkRun::correctionsPerMinute).average().orElse(0);
  }

  /** Returns the report for people, several lines. */
  public String text() {
    StringBuilder text = new StringBuilder();
    text.append(
        String.format(
            Locale.ROOT,
            "%s on \"%s\": %.0f s of play on each network, seed=%d%n%n",
            game,
            level,
            seconds,
            seed));
    text.append(
        String.format(
            Locale.ROOT,
            "%-14s %7s %15s %13s %14s%n",
            "network",
            "players",
            "corrections/min",
            "predictions",
            "kbit/s"));
    for (NetworkRun run : runs) {
      text.append(
          String.format(
              Locale.ROOT,
              "%-14s %7d %15.1f %7.2f %% ok %14.1f%n",
              run.network(),
              run.players(),
              run.correctionsPerMinute(),
              run.rightPercent(),
              run.kbitPerSecond()));
    }
    text.append(System.lineSeparator());
    for (NetworkRun run : runs) {
      String costs = costs(run);
      if (!costs.isEmpty()) {
        text.append("own bodies shifted, ").append(run.network()).append(", players=");
        text.append(run.players()).append(": ").append(costs).append(System.lineSeparator());
      }
    }
    text.append(
        msPerTick > 0
            ? String.format(
                Locale.ROOT,
                "%na tick takes %.3f ms on this machine and allocates %.0f bytes (the engine:"
                    + " 0)%n%n",
                msPerTick,
                bytesPerTick)
            : String.format(Locale.ROOT, "%na tick wasn't measured, because the game fails%n%n"));
    for (String rule : broken) {
      text.append("rule broken: ").append(rule).append(System.lineSeparator());
    }
    text.append(
        broken.isEmpty()
            ? "No rule is broken: same seed, rollback and saved states give the same game."
            : broken.size() + (broken.size() == 1 ? " rule is" : " rules are") + " broken.");
    return text.toString();
  }

  /** Returns why own bodies were shifted: how often, and the share of each cause. */
  private String costs(NetworkRun run) {
    long sum = run.costs().stream().mapToLong(Costs.Cost::times).sum();
    if (sum == 0) {
      return "";
    }
    StringBuilder text = new StringBuilder();
    text.append(String.format(Locale.ROOT, "%.1f/min, ", sum * 60 / seconds / run.players()));
    for (int i = 0; i < Math.min(MOST_COSTS, run.costs().size()); i++) {
      Costs.Cost cost = run.costs().get(i);
      text.append(i == 0 ? "" : ", ").append(cost.cause());
      text.append(String.format(Locale.ROOT, " %.0f %%", 100.0 * cost.times() / sum));
    }
    return text.toString();
  }

  /** Returns the report as one line of JSON. */
  public String json() {
    StringWriter out = new StringWriter();
    try (JsonGenerator g = new JsonFactory().createGenerator(out)) {
      g.writeStartObject();
      g.writeStringField("game", game);
      g.writeStringField("level", level);
      g.writeNumberField("seed", seed);
      g.writeNumberField("seconds", seconds);
      g.writeArrayFieldStart("runs");
      for (NetworkRun run : runs) {
        g.writeStartObject();
        g.writeStringField("network", run.network());
        g.writeNumberField("players", run.players());
        g.writeNumberField("correctionsPerMinute", run.correctionsPerMinute());
        g.writeNumberField("rightPercent", run.rightPercent());
        g.writeNumberField("kbitPerSecond", run.kbitPerSecond());
        g.writeArrayFieldStart("shifts");
        for (Costs.Cost cost : run.costs()) {
          g.writeStartObject();
          g.writeStringField("cause", cost.cause());
          g.writeNumberField("perMinute", cost.times() * 60 / seconds / run.players());
          g.writeEndObject();
        }
        g.writeEndArray();
        g.writeEndObject();
      }
      g.writeEndArray();
      g.writeNumberField("msPerTick", msPerTick);
      g.writeNumberField("bytesPerTick", bytesPerTick);
      g.writeArrayFieldStart("broken");
      for (String rule : broken) {
        g.writeString(rule);
      }
      g.writeEndArray();
      g.writeEndObject();
    } catch (IOException e) {
      throw new UncheckedIOException(e); // can't happen in memory
    }
    return out.toString();
  }
}
