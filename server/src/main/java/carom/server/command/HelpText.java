package carom.server.command;

import java.util.Collection;

/** Writes help in two columns that fit a terminal of 80 characters and break between words. */
final class HelpText {
  private static final int WIDTH = 79;

  /** Column at which descriptions begin. A longer usage has a line of its own. */
  private static final int COLUMN = 26;

  private HelpText() {}

  /** Returns the usage and the purpose of each command. */
  static String of(Collection<Command> commands) {
    StringBuilder text = new StringBuilder();
    for (Command command : commands) {
      String usage = command.synopsis();
      boolean fits = usage.length() + 2 <= COLUMN;
      text.append(usage).append(fits ? " ".repeat(COLUMN - usage.length()) : "\n");
      String doc = wrap(command.doc(), COLUMN);
      text.append(fits ? doc.stripLeading() : doc).append('\n');
    }
    return text.toString();
  }

  /** Returns a text in lines that begin with a number of spaces and break between words. */
  static String wrap(String text, int indent) {
    return wrap(text.split(" "), indent);
  }

  /** Returns a list of clauses in lines that break behind commas. */
  static String wrapClauses(String text) {
    return wrap(text.split("(?<=,) "), 0);
  }

  private static String wrap(String[] parts, int indent) {
    StringBuilder lines = new StringBuilder();
    int column = WIDTH;
    for (String word : parts) {
      if (column + 1 + word.length() > WIDTH) {
        lines.append(lines.isEmpty() ? "" : "\n").append(" ".repeat(indent)).append(word);
        column = indent + word.length();
      } else {
        lines.append(' ').append(word);
        column += 1 + word.length();
      }
    }
    return lines.toString();
  }
}
