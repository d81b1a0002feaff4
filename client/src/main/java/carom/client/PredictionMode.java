package carom.client;

import carom.net.protocol.InputDatagram;
import java.util.Locale;

/** The things that a client simulates ahead of the server. */
public enum PredictionMode {
  /**
   * The client predicts nothing. The own body is interpolated like all others; for spectators and
   * cheap bots.
   */
  NONE,
  /**
   * The client predicts its own body and the bodies that this one touches, directly or through
   * others, or may touch soon.
   */
  ISLAND,
  /**
   * The client predicts as many bodies around its own one as the server can send exactly, the
   * closest first.
   */
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
