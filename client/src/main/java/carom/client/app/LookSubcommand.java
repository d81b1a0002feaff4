package carom.client.app;

import carom.options.Subcommand;

/** Brings {@code look} to the program {@code carom}; found as {@link Subcommand}. */
public final class LookSubcommand implements Subcommand {
  /** Creates it, for the service loader. */
  public LookSubcommand() {}

  @Override
  public String name() {
    return "look";
  }

  @Override
  public Object command() {
    return new LookCommand();
  }
}
