package carom.client;

import carom.net.protocol.InputDatagram;
import java.util.Locale;

/** The things that a client simulates ahead of the server. */
public enum PredictionMode {
  /** Nothing. The own body is interpolated like all others; for spectators and cheap bots. */
  NONE,
  /** The own body, the bodies it touches, directly or through others, or may touch soon. */
  ISLAND,
  /** As many bodies around the own one as the server can send exactly, the closest first. */
  ALL;

  /** Returns the value of this mode in an {@link InputDatagram}. */
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
