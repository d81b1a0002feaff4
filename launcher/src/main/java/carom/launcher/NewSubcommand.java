package carom.launcher;

import carom.options.Subcommand;

/** Brings {@code new} to the program {@code carom}; found as {@link Subcommand}. */
public final class NewSubcommand implements Subcommand {
  /** Creates it, for the service loader. */
  public NewSubcommand() {}

  @Override
  public String name() {
    return "new";
  }

  @Override
  public Object command() {
    return new NewCommand();
  }
}
