package carom.server.jmx;

/**
 * The commands of a server, for any JMX tool, under the name {@code carom:type=Server}. Public,
 * because JMX requires it.
 */
public interface CommandMXBean {
  /**
   * Carries out a command as an operator.
   *
   * @param line a command and its words, such as {@code kick Mallory}
   * @return the answer
   */
  String run(String line);

  /** Returns the names of all commands. */
  String[] getCommands();
}
