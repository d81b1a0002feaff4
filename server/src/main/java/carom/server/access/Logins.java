package carom.server.access;

import java.util.function.LongSupplier;

/**
 * The doors of a server at which operators log in, each with its own limit.
 *
 * @param page the live page
 * @param rcon remote consoles
 */
public record Logins(LoginThrottle page, LoginThrottle rcon) {
  /**
   * Returns doors without failed tries.
   *
   * @param clock monotonic nanoseconds
   */
  public static Logins begin(LongSupplier clock) {
    return new Logins(new LoginThrottle(clock), new LoginThrottle(clock));
  }
}
