package carom.client.desktop;

import carom.client.desktop.hud.ShownGame;
import carom.client.view.ClientView;
import carom.net.protocol.ServerMessage.RosterEntry;

/**
 * Notices that the own player is in another team than before, as the next match of a room may have
 * arranged its teams anew. Render thread only.
 */
final class TeamNews {
  private final ShownGame game;
  private String room = "";
  private String about = "";
  private int team;

  /** Creates one that knows no team. The game stays the property of the caller. */
  public TeamNews(ShownGame game) {
    this.game = game;
  }

  /** Returns in words for the player that the team is another one; an empty text if it isn't. */
  public String take(ClientView view) {
    RosterEntry own = view.participant(view.playerId());
    if (own == null || own.spectator() || own.team() == 0 || game.teamCount() == 0) {
      return "";
    }
    boolean here = room.equals(view.room()) && about.equals(view.game());
    boolean changed = here && own.team() != team;
    room = view.room();
    about = view.game();
    team = own.team();
    return changed ? "You play for " + game.team(team) + " now" : "";
  }
}
