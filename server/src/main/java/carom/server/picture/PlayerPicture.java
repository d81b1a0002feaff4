package carom.server.picture;

import carom.server.replication.LinkFigures;
import carom.server.session.PlayerInfo;

/**
 * A player as people who watch the room see it. Immutable.
 *
 * @param info name, address, state and score
 * @param link what the line and the client's predictions have done since the link began
 * @param inputsMissing inputs of the session that had not arrived when their tick ran
 */
public record PlayerPicture(PlayerInfo info, LinkFigures link, long inputsMissing) {}
