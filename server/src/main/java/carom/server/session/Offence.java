package carom.server.session;

import carom.net.protocol.SessionState;
import java.util.Locale;

/** The words for a message that breaks the protocol. The player and the log read them. */
final class Offence {
  private Offence() {}

  /**
   * Returns what is wrong with a message that the state doesn't allow.
   *
   * @param message null for one that couldn't be decoded
   */
  static String of(Object message, SessionState state) {
    return message == null
        ? "an undecodable message"
        : message.getClass().getSimpleName() + " while " + state.name().toLowerCase(Locale.ROOT);
  }
}
