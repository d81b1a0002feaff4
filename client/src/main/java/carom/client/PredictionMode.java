package carom.client;

import carom.net.protocol.InputDatagram;
import java.util.Locale;

/** What a client simulates ahead of the server. */
public enum PredictionMode {
  /** Nothing: the own body is drawn in the past like all others. For spectators and cheap bots. */
  NONE,
  /** The own body, what it touches, directly or through others, and what it may touch soon. */
  ISLAND,
  /** As much around the own body as the server has room to tell exactly, the closest first. */
  ALL;

  /** How an {@link InputDatagram} says it. */
  int near() {
    return switch (this) {
      case NONE -> InputDatagram.NEAR_NONE;
      case ISLAND -> InputDatagram.NEAR_ISLAND;
      case ALL -> InputDatagram.NEAR_ALL;
    };
  }

  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
