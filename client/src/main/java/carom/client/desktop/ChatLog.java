package carom.client.desktop;

import carom.sim.message.BuiltInKinds;
import java.util.ArrayList;
import java.util.List;

/**
 * The last lines that were said, and the line that the player writes. It draws nothing. One thread.
 */
final class ChatLog {
  /** Most lines that are kept. */
  static final int MOST_LINES = 8;

  /**
   * A line that was said.
   *
   * @param who name of the one who said it; empty for the server
   * @param team whether only the team heard it
   * @param arrivedNs when it arrived
   */
  record Line(String who, boolean team, String text, long arrivedNs) {}

  private final List<Line> lines = new ArrayList<>();
  private final StringBuilder draft = new StringBuilder();
  private boolean open;
  private boolean toTeam;

  /** Adds a line; the oldest goes if there are too many. */
  void add(Line line) {
    if (lines.size() == MOST_LINES) {
      lines.remove(0);
    }
    lines.add(line);
  }

  /** Returns the last lines, oldest first. Do not change the list. */
  List<Line> lines() {
    return lines;
  }

  /** Begins a line, to the team alone or to all. */
  void open(boolean team) {
    open = true;
    toTeam = team;
    draft.setLength(0);
  }

  /** Gives the line up. */
  void close() {
    open = false;
  }

  /** Returns whether a line is being written. */
  boolean isOpen() {
    return open;
  }

  /** Returns whether the line is for the team alone. */
  boolean isToTeam() {
    return toTeam;
  }

  /** Appends what was typed. Control characters and what exceeds the longest line are dropped. */
  void type(char typed) {
    if (open && !Character.isISOControl(typed) && draft.length() < BuiltInKinds.MAX_CHAT) {
      draft.append(typed);
    }
  }

  /** Removes the last character. */
  void erase() {
    if (draft.length() > 0) {
      draft.setLength(draft.offsetByCodePoints(draft.length(), -1));
    }
  }

  /** Returns the line so far. */
  String draft() {
    return draft.toString();
  }
}
