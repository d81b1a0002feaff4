package carom.options;

/**
 * A command of the program {@code carom} that another part of the installation brings. The program
 * finds it by {@link java.util.ServiceLoader}, so neither part knows the other.
 */
public interface Subcommand {
  /** Returns the word that users type. */
  String name();

  /** Returns a new object with the annotations of picocli. */
  Object command();
}
