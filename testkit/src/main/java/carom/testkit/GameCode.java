package carom.testkit;

/** Tells which classes are a game's own: its class, those within, its package and below. */
record GameCode(Class<?> game) {
  /** Returns whether a class is the game's own. */
  boolean isOfGame(String className) {
    String ours = game.getName();
    String home = game.getPackageName();
    return className.equals(ours)
        || className.startsWith(ours + "$")
        || (!home.isEmpty() && className.startsWith(home + "."));
  }

  /** Returns class, method and line, such as {@code Tag.hurt (Tag.java:57)}. */
  String line(StackTraceElement at) {
    return line(at.getClassName(), at.getMethodName(), at.getFileName(), at.getLineNumber());
  }

  /**
   * Returns class, method and line, such as {@code Tag.hurt (Tag.java:57)}.
   *
   * @param file name of the source, or null if the class was compiled without it
   */
  String line(String className, String method, String file, int line) {
    String simple = className.substring(className.lastIndexOf('.') + 1).replace('$', '.');
    return simple + "." + method + (file == null ? "" : " (" + file + ":" + line + ")");
  }
}
