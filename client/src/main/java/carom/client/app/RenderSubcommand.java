package carom.client.app;

import carom.options.Subcommand;

/** Brings {@code render} to the program {@code carom}; found as {@link Subcommand}. */
public final class RenderSubcommand implements Subcommand {
  /** Creates it, for the service loader. */
  public RenderSubcommand() {}

  @Override
  public String name() {
    return "render";
  }

  @Override
  public Object command() {
    return new RenderCommand();
  }
}
