package carom.client.link;

import carom.net.protocol.ServerMessage;
import carom.sim.level.Level;

/** Receives what a {@link Connection} brings, on its thread. */
public interface ConnectionListener {
  /**
   * Begins to play: the server has let the client in and the level is here.
   *
   * @return null, or why this client can't play, in words for the player
   */
  String joined(ServerMessage.Welcome welcome, Level level);

  /** Returns the digest of the declarations of the game that was joined last. */
  long declarationsDigest();

  /** Returns the digest of the code of the game that was joined last, as the server is told it. */
  long gameDigest();

  /**
   * Receives a datagram that arrived while playing.
   *
   * @param arrivedNs when, by the clock of {@code update}; a frame may have passed since
   */
  void datagram(byte[] bytes, int length, long arrivedNs);

  /** Receives a list of players that has changed. */
  void roster(ServerMessage.Roster roster);

  /** Receives a part of the list of rooms. */
  void rooms(ServerMessage.RoomList rooms);

  /** Receives the best lists. */
  void best(ServerMessage.BestLists lists);

  /** Receives a part of the list of levels of players. */
  void levels(ServerMessage.LevelList levels);

  /** Receives a line of the server for the player. */
  void notice(String text);

  /** Receives where the server's page for browsers is; null with a new link, until it tells. */
  void playPage(String host, ServerMessage.PlayPage page);

  /** Receives the pace at which time passes from now on, and whether views are narrow. */
  void pace(ServerMessage.Pace pace);

  /** Receives a reliable message of the game. */
  void message(ServerMessage.GameMessage message);

  /** Receives which messages of the game the server has heard. */
  void heard(ServerMessage.Heard message);

  /** Receives a piece of the state of the level's pools. */
  void pools(ServerMessage.PoolChunk chunk);

  /** Stops to play, for now or for good. */
  void stopped();
}
