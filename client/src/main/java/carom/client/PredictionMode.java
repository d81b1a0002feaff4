package carom.client;

import java.util.Locale;

/** What a client simulates ahead of the server. */
public enum PredictionMode {
  /** Nothing: the own body is drawn in the past like all others. For spectators and cheap bots. */
  NONE,
  /** The own body, and the bodies near it that it may push. */
  OWN;

  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
