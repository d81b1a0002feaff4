package carom.client;

import carom.client.link.Connection;
import carom.net.protocol.ClientMessage;

/**
 * Tells the server which part of the level is shown, when that changes and at most a few times a
 * second. One client's; one thread.
 */
final class InterestReporter {
  private static final long GAP_NS = 200_000_000L;

  /** Reported size relative to the shown one, so that nothing appears at the edge of the screen. */
  private static final float MARGIN = 1.2f;

  private float x;
  private float y;
  private float halfWidth = Float.MAX_VALUE; // as much as the server allows
  private float halfHeight = Float.MAX_VALUE;
  private ClientMessage.Look look;
  private ClientMessage.Look sent;
  private long sentNs;

  /**
   * Sets what is shown.
   *
   * @param x middle of the picture, metres
   * @param y middle of the picture, metres
   * @param width of the picture, metres
   * @param height of the picture, metres
   */
  void show(float x, float y, float width, float height) {
    this.x = x;
    this.y = y;
    halfWidth = width / 2 * MARGIN;
    halfHeight = height / 2 * MARGIN;
    look = new ClientMessage.Look(x, y, halfWidth, halfHeight, follows());
  }

  /**
   * Sets the player that the picture follows while there is no own body.
   *
   * @param player id, or {@link ClientMessage.Look#NOBODY}
   */
  void follow(int player) {
    if (player != follows()) {
      look = new ClientMessage.Look(x, y, halfWidth, halfHeight, player);
    }
  }

  private int follows() {
    return look == null ? ClientMessage.Look.NOBODY : look.follows();
  }

  /** Forgets what was sent: a new link knows nothing. */
  void reset() {
    sentNs = 0;
  }

  /** Sends what is shown if the server doesn't know it and a message is due. */
  void sendIfDue(Connection connection, long nowNs) {
    boolean first = sentNs == 0;
    boolean due = first || nowNs - sentNs >= GAP_NS;
    if (look != null && due && (first || !look.equals(sent))) {
      connection.send(look);
      sent = look;
      sentNs = nowNs;
    }
  }
}
