package carom.server.command;

import carom.net.snapshot.Explanation;
import carom.server.replication.SentReport;
import java.util.Locale;

/** Writes a {@link SentReport} for people: what happened in a sentence, and the numbers below. */
final class WhyText {
  private WhyText() {}

  /** Returns lines of at most 79 characters, unless the player's name is very long. */
  static String of(String player, SentReport report) {
    Explanation e = report.why();
    TextTable table = new TextTable("name", "value", "what it is");
    table.add("tick", e.tick(), "newest tick of the room");
    table.add(
        "acked",
        e.ackedTick(),
        ago(e, e.ackedTick(), "newest tick at which the client has it", "the client has none"));
    table.add(
        "sent",
        e.sentTick(),
        ago(e, e.sentTick(), "last tick at which it was sent", "it was never sent"));
    table.add("priority", decimal(e.priority()), "what it collects with each tick");
    table.add("collected", decimal(e.collected()), "what it has collected since it was sent");
    table.add(
        "needed",
        decimal(e.needed()),
        e.needed() == 0
            ? "the last snapshot had room for everything"
            : "least that anything in the last snapshot had");
    table.add("waiting", e.waiting(), "entities that wait for the next snapshot");
    table.add("budget", e.budgetBytes(), "bytes that the last snapshot could have");
    table.add("ahead", e.aheadBytes(), "bytes of it that went to all but entities");
    table.add("near", e.nearBytes(), "bytes of those for exact state of what is near");
    table.add("nearRowsWaiting", report.nearRowsWaiting(), "rows of that state that still wait");
    table.add("paceBytesPerSecond", report.paceBytesPerSecond(), "what the line is given");
    return HelpText.wrap(outcome(player, e) + coding(e), 0) + "\n\n" + table;
  }

  private static String decimal(float value) {
    return String.format(Locale.ROOT, "%.3f", value);
  }

  private static String ago(Explanation e, int tick, String what, String never) {
    int ticks = e.tick() - tick;
    return tick < 0 ? never : what + ", " + ticks + (ticks == 1 ? " tick ago" : " ticks ago");
  }

  /** Says what became of the entity in the last snapshot, with the name that the protocol has. */
  private static String outcome(String player, Explanation e) {
    String text =
        switch (e.reason()) {
          case FREE -> "There is no entity %d, and %s's client shows none";
          case OUT_OF_SIGHT -> "Entity %d is outside %s's view, or the game hides it";
          case UP_TO_DATE -> "Entity %d was not sent, because %s's client has its present state";
          case SENT -> "Entity %d was sent to %s with the last snapshot";
          case UNACKED -> "Entity %d was sent to %s, and is sent again until acknowledged";
          case OVER_BUDGET ->
              "Entity %d was not sent to %s, because others had collected more priority and"
                  + " used up the budget";
          case NOT_DUE ->
              "Entity %d has changed since %s's last snapshot, and the next one tells it";
        };
    return text.formatted(e.slot(), player) + " (" + e.reason() + ").";
  }

  /** Says what the record is, or would be; empty for none. */
  private static String coding(Explanation e) {
    String text =
        switch (e.baseline()) {
          case QUIESCENT -> "";
          case ACKED -> "Its record is the difference to tick " + e.ackedTick();
          case NEW -> "Its record is whole, because the client has acknowledged none in its view";
          case TOO_OLD -> "Its record is whole, because the acknowledged one is 64 ticks old";
          case ROLLED_OUT -> "Its record is whole, because the server lost the acknowledged state";
          case IDENTITY ->
              "Its record is whole, because the client has another entity there, or it was"
                  + " teleported";
          case FORCED -> "Its record is whole, because it was asked for";
          case GONE -> "Its record says that it is gone";
          case OUT_OF_SIGHT -> "Its record says that it has left the view";
        };
    return text.isEmpty() ? "" : " " + text + " (" + e.baseline() + ").";
  }
}
