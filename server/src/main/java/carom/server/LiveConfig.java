package carom.server;

import carom.server.config.ServerConfig;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;

/**
 * The settings of a server that runs. Most stay as they were at the start; those that an operator
 * may change are read anew whenever they are used. Any thread.
 */
final class LiveConfig implements Supplier<ServerConfig> {
  private volatile ServerConfig present;

  /** Creates settings without changes. */
  public LiveConfig(ServerConfig start) {
    present = start;
  }

  @Override
  public ServerConfig get() {
    return present;
  }

  /**
   * Puts other settings in force.
   *
   * @param change returns the next settings for the present ones
   */
  public synchronized void change(UnaryOperator<ServerConfig> change) {
    present = change.apply(present);
  }
}
