package carom.sim.level;

/** Says why a level file cannot be used, and where in the file. */
public final class LevelException extends Exception {
  private static final long serialVersionUID = 1;

  private final String file;
  private final int line;
  private final int column;
  private final String field;

  /**
   * Creates the exception.
   *
   * @param file name of the file as the user knows it
   * @param line line from 1, or 0 when the problem has no place in the file
   * @param column column from 1, or 0
   * @param field path such as {@code bodies[3].shape.radius}, or empty
   * @param problem the rest of the sentence that begins with the field: {@code =-1 must be > 0}
   */
  public LevelException(String file, int line, int column, String field, String problem) {
    super(file + (line > 0 ? ":" + line + ":" + column : "") + ": " + field + problem);
    this.file = file;
    this.line = line;
    this.column = column;
    this.field = field;
  }

  /** Returns the name of the file as the user knows it. */
  public String file() {
    return file;
  }

  /** Returns the line from 1, or 0 when the problem has no place in the file. */
  public int line() {
    return line;
  }

  /** Returns the column from 1, or 0 when the problem has no place in the file. */
  public int column() {
    return column;
  }

  /**
   * Returns the path of the field, such as {@code bodies[3].shape.radius}; empty for the file as a
   * whole.
   */
  public String field() {
    return field;
  }
}
