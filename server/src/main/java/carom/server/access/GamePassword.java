package carom.server.access;

import java.net.InetAddress;

/**
 * The password that players and spectators must know. Wrong ones are limited for each address, as
 * at other doors. Any thread.
 */
public final class GamePassword {
  private final Secret secret;
  private final LoginThrottle throttle;

  /** Creates a password without failed tries. */
  public GamePassword(Secret secret, LoginThrottle throttle) {
    this.secret = secret;
    this.throttle = throttle;
  }

  /**
   * Returns why a player may not come in, as a text for the player; empty without a password, null
   * if it is right.
   *
   * @param shown the password that was shown, or null for none
   */
  public String problem(String shown, InetAddress from) {
    if (throttle.mustWait(from)) {
      return "Too many wrong ones came from your address; wait a minute.";
    }
    if (shown == null) {
      return "";
    }
    if (secret.matches(shown)) {
      throttle.right(from);
      return null;
    }
    throttle.wrong(from);
    return "Yours is wrong.";
  }
}
