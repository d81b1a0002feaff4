package carom.server.session;

import carom.server.replication.LinkFigures;
import java.util.Locale;

/**
 * The description of a player for an operator. Immutable.
 *
 * @param id the player's id, 0..1,023
 * @param name unique in the room
 * @param account the account by the player's join token, or empty
 * @param remote address and port of the client, or why there is none
 * @param state {@code playing}, {@code watching}, {@code loading}, {@code grace} or {@code bot}
 * @param team the player's team
 * @param score the player's score
 * @param rgb the colour that the player has chosen, 0xRRGGBB; -1 for none
 * @param link what the line and the predictions have done since the link began
 * @param playedTicks ticks for which the player has played over its present link
 */
public record PlayerInfo(
    int id,
    String name,
    String account,
    String remote,
    String state,
    int team,
    int score,
    int rgb,
    LinkFigures link,
    int playedTicks) {
  /** Describes a session. The room's thread. */
  public static PlayerInfo of(Session session) {
    boolean watches = session.player().isSpectator();
    return new PlayerInfo(
        session.seat().id(),
        session.shownName(),
        session.seat().account(),
        session.remote(),
        session.isBot()
            ? "bot"
            : watches ? "watching" : session.state().name().toLowerCase(Locale.ROOT),
        session.player().team(),
        session.player().score(),
        session.player().colour().rgb(),
        session.replication().figures(),
        session.playedTicks());
  }
}
