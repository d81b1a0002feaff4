package carom.server.command;

/**
 * Somebody who gives commands. Immutable.
 *
 * @param role how far it is trusted
 * @param way how the commands come: {@code console}, {@code page}, {@code rcon}, {@code chat}
 * @param name who it is, such as an address; empty at the console
 */
public record Caller(Role role, String way, String name) {
  /** The server's own console, and programs that write to its standard input. */
  public static final Caller CONSOLE = new Caller(Role.CONSOLE, "console", "");

  /** The server itself, which does what a signal asks for. */
  public static final Caller SIGNAL = new Caller(Role.CONSOLE, "signal", "");

  /** Returns way and name, for the log. */
  @Override
  public String toString() {
    return name.isEmpty() ? way : way + " " + name;
  }
}
