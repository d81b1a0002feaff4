package carom.client.desktop.hud;

import carom.client.view.ClientView;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.entity.Input;

/**
 * Finds out that the last player that a warm-up waits for is there, without a key for it: all
 * others, such as bots, are ready, and the player moves. A player that has said by key not to be
 * ready is left alone for the rest of that match. Render thread only.
 */
public final class Readiness {
  private String room = "";
  private int match;
  private boolean moved;
  private boolean declined;
  private boolean said;

  /** Creates one that knows nothing. */
  public Readiness() {}

  /** Takes note of the input of a tick. */
  public void sampled(ClientView view, Input input) {
    follow(view);
    moved |= input.moveX() != 0 || input.moveY() != 0 || input.held(Input.ACTION);
  }

  /** Takes note that the player said by key to be ready or not. */
  public void asked(ClientView view, boolean ready) {
    follow(view);
    declined = !ready;
  }

  /**
   * Finds out whether to tell the server now that the player is ready, and notes that it was told.
   * Returns true at most once in a match.
   *
   * @param clock of the game that is shown, or null
   */
  public boolean find(ClientView view, MatchClock clock) {
    follow(view);
    boolean found = moved && !declined && !said && waits(view, clock);
    said |= found;
    return found;
  }

  private void follow(ClientView view) {
    if (view.matchNumber() != match || !view.room().equals(room)) {
      match = view.matchNumber();
      room = view.room();
      moved = false;
      declined = false;
      said = false;
    }
  }

  /** Returns whether a warm-up waits for the own player alone, but has enough players. */
  public static boolean waits(ClientView view, MatchClock clock) {
    boolean warm =
        clock != null
            && clock.waitsForReady()
            && view.knowsFields()
            && MatchClock.phase(view.match()) == MatchPhase.WARM_UP;
    if (!warm) {
      return false;
    }
    int players = 0;
    int ready = 0;
    boolean own = false;
    for (int i = 0; i < view.players().size(); i++) {
      RosterEntry entry = view.players().get(i);
      players += entry.spectator() ? 0 : 1;
      ready += !entry.spectator() && entry.ready() ? 1 : 0;
      own |= entry.playerId() == view.playerId() && !entry.spectator() && !entry.ready();
    }
    return own && ready == players - 1 && players >= Math.max(2, clock.playersToBegin());
  }
}
