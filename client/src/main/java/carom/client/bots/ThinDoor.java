package carom.client.bots;

import java.io.IOException;

/** A thin client's open connection; what it is told goes to a {@link ThinPicture}. One thread. */
public interface ThinDoor extends AutoCloseable {
  /**
   * The place that a client asks for.
   *
   * @param server address of another server of the fleet, {@code host:port} or, by KryoNet, {@code
   *     host:tcp:udp}; empty for the opener's own
   * @param room name of the room; empty for any
   * @param secret of the seat to take again, as the door writes it; empty for none
   * @param token what a redirect has given; empty for none
   */
  record Goal(String server, String room, String secret, String token) {}

  /** Opens connections. Any thread. */
  interface Opener {
    /**
     * Opens a connection and asks to join; blocks for up to some seconds.
     *
     * @param name of the player
     * @param goal where to
     * @param told learns what comes
     * @throws IOException if the server can't be reached
     */
    ThinDoor open(String name, Goal goal, ThinPicture told) throws IOException;
  }

  /**
   * Sends the player's input.
   *
   * @param count the client's own count, one more for each
   * @param seen tick of the newest snapshot of which all parts are here; -1 for none
   * @param buttons that are down
   * @param moveX to the right, -1..1
   * @param moveY upwards, -1..1
   * @param aim radians counterclockwise from +x
   */
  void input(int count, int seen, int buttons, float moveX, float moveY, float aim);

  /** Returns the payload bytes that were sent; 0 if the library doesn't tell. */
  long bytesOut();

  /** Leaves the game and closes. */
  @Override
  void close();
}
