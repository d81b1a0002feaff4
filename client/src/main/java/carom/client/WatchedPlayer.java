package carom.client;

import carom.client.view.ClientView;
import carom.net.protocol.ServerMessage.RosterEntry;
import java.util.List;

/**
 * Chooses the player that the picture follows while the own player watches or is out: one of the
 * own team if any of it is alive, or any other. It stays with a player who is alive and seen, until
 * the user wants another. The roster says who is alive. One client's; one thread.
 */
final class WatchedPlayer {
  static final int NOBODY = -1;

  /** Time in which the picture stays where the own body was; most games give another soon. */
  private static final long STAY_NS = 1_500_000_000L;

  /** Time after which the picture leaves a player that it doesn't see. */
  private static final long UNSEEN_NS = 2_000_000_000L;

  private static final long LOOK_NS = 250_000_000L;

  private int watched = NOBODY;
  private boolean out;
  private long outNs;
  private long seenNs;
  private long lookedNs;

  /** Returns the player to follow, or {@link #NOBODY}. */
  int id() {
    return watched;
  }

  /** Follows no player any more: the roster is another. */
  void reset() {
    watched = NOBODY;
    out = false;
  }

  /** Looks whether to follow a player, and which. */
  void update(ClientView view, long nowNs) {
    RosterEntry own = view.participant(view.playerId());
    if (own == null || own.alive()) {
      reset();
      return;
    }
    if (!out) {
      out = true;
      outNs = nowNs;
    }
    if (watched == NOBODY && !own.spectator() && nowNs - outNs < STAY_NS) {
      return;
    }
    if (watched == NOBODY || !isAlive(view, watched) || isUnseen(view, nowNs)) {
      follow(choose(view, own), nowNs);
    }
  }

  /** Follows the next player, or the one before, if the own player is out. */
  void next(ClientView view, int step, long nowNs) {
    if (out) {
      follow(other(view.players(), watched, step), nowNs);
    }
  }

  private void follow(int id, long nowNs) {
    watched = id;
    seenNs = nowNs;
  }

  private boolean isUnseen(ClientView view, long nowNs) {
    if (nowNs - lookedNs >= LOOK_NS) {
      lookedNs = nowNs;
      seenNs = view.watched() == null ? seenNs : nowNs;
    }
    return nowNs - seenNs > UNSEEN_NS;
  }

  private static boolean isAlive(ClientView view, int id) {
    RosterEntry entry = view.participant(id);
    return entry != null && entry.alive();
  }

  private int choose(ClientView view, RosterEntry own) {
    for (int i = 0; watched == NOBODY && i < view.players().size(); i++) {
      RosterEntry entry = view.players().get(i);
      if (entry.alive() && entry.team() == own.team()) {
        return entry.playerId();
      }
    }
    return other(view.players(), watched, 1);
  }

  /** Returns the player alive after another by id, going round; NOBODY if nobody is. */
  private static int other(List<RosterEntry> players, int than, int step) {
    int count = players.size();
    int from = step > 0 ? -1 : count;
    for (int i = 0; i < count; i++) {
      from = players.get(i).playerId() == than ? i : from;
    }
    for (int i = 1; i <= count; i++) {
      RosterEntry entry = players.get(Math.floorMod(from + i * step, count));
      if (entry.alive()) {
        return entry.playerId();
      }
    }
    return NOBODY;
  }
}
