package carom.server.config;

import carom.net.protocol.ProtocolLimits;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * One value of {@code --bots}: {@code [ROOM=]N[:STRENGTH]}.
 *
 * @param room name of the room; empty for all that have no rule of their own
 * @param players number of players up to which bots come; 0 = none come
 * @param strength {@code weak}, {@code medium} or {@code strong}; empty for one by chance
 */
public record BotRule(String room, int players, String strength) {
  /** The rule of a room without bots. */
  public static final BotRule NONE = new BotRule("", 0, "");

  private static final Pattern FORM =
      Pattern.compile("(?:([^=]+)=)?(\\d{1,4})(?::(weak|medium|strong))?");

  /**
   * Reads a value.
   *
   * @throws IllegalArgumentException if it has another form; the message says how to write it
   */
  public static BotRule parse(String text) {
    Matcher parts = FORM.matcher(text.strip());
    if (!parts.matches()) {
      throw new IllegalArgumentException(
          " isn't [ROOM=]N[:STRENGTH] with a strength weak, medium or strong; for example 4, or"
              + " cup=6:strong");
    }
    int players = Integer.parseInt(parts.group(2));
    if (players > ProtocolLimits.MAX_PLAYERS) {
      throw new IllegalArgumentException(
          ": players=" + players + " is outside 0.." + ProtocolLimits.MAX_PLAYERS);
    }
    return new BotRule(
        parts.group(1) == null ? "" : parts.group(1),
        players,
        parts.group(3) == null ? "" : parts.group(3));
  }

  /** Returns the rule for a room: the last that names it, or else the last for all. */
  public static BotRule of(List<BotRule> rules, String room) {
    BotRule all = NONE;
    BotRule own = null;
    for (BotRule rule : rules) {
      all = rule.room.isEmpty() ? rule : all;
      own = rule.room.equals(room) ? rule : own;
    }
    return own == null ? all : own;
  }

  /** Returns the value as it is written. */
  @Override
  public String toString() {
    return (room.isEmpty() ? "" : room + "=")
        + players
        + (strength.isEmpty() ? "" : ":" + strength);
  }
}
