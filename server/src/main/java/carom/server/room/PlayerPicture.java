package carom.server.room;

import carom.server.replication.LinkFigures;
import carom.server.session.PlayerInfo;

/**
 * A player as people who watch the room see it. Immutable.
 *
 * @param info name, address, state, score and link
 * @param inputsMissing inputs of the session that had not arrived when their tick ran
 */
public record PlayerPicture(PlayerInfo info, long inputsMissing) {
  /** Returns what the line and the client's predictions have done since the link began. */
  public LinkFigures link() {
    return info.link();
  }
}
