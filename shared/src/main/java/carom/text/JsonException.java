package carom.text;

/** Tells what is wrong with a JSON document, and where. The message is a sentence's end. */
public final class JsonException extends Exception {
  private static final long serialVersionUID = 1;

  private final int line;
  private final int column;
  private final String path;

  JsonException(int line, int column, String path, String problem) {
    super(problem);
    this.line = line;
    this.column = column;
    this.path = path;
  }

  /** Returns the line from 1, or 0 when the problem has no place. */
  public int line() {
    return line;
  }

  /** Returns the column from 1, or 0 when the problem has no place. */
  public int column() {
    return column;
  }

  /** Returns the path of the node, such as {@code bodies[3].at}, or an empty text. */
  public String path() {
    return path;
  }
}
