package carom.sim.entity;

import carom.physics.archive.Archive;
import carom.sim.field.Scope;
import java.util.Arrays;

/** The saved state of a {@link PlayerTable}, a column each. The arrays are reused. */
public final class SavedPlayers {
  private static final int MAX_NAME = 1 << 16;

  final SavedFields fields;
  int limit;
  HostPlayer[] players = {};
  HostEntity[] bodies = {};
  int[] scores = {};
  int[] teams = {};
  int[] standings = {};
  long[] inputs = {};
  int[] viewDelays = {};

  /**
   * Creates the state of no players.
   *
   * @param fields receives their fields
   */
  public SavedPlayers(SavedFields fields) {
    this.fields = fields;
  }

  /** Sets a number above all ids, and forgets the players beyond it. */
  void limit(int newLimit) {
    if (newLimit > players.length) {
      int grown = Math.max(newLimit, 2 * players.length);
      players = Arrays.copyOf(players, grown);
      bodies = Arrays.copyOf(bodies, grown);
      scores = Arrays.copyOf(scores, grown);
      teams = Arrays.copyOf(teams, grown);
      standings = Arrays.copyOf(standings, grown);
      inputs = Arrays.copyOf(inputs, grown);
      viewDelays = Arrays.copyOf(viewDelays, grown);
    }
    Arrays.fill(players, newLimit, Math.max(newLimit, limit), null);
    limit = newLimit;
  }

  /**
   * Reads or writes the state.
   *
   * @param table those of its players who are the same are taken over
   * @param entities among which are their bodies, read already
   */
  public void pass(Archive a, PlayerTable table, SavedEntities entities) {
    limit(a.count("players", limit, PlayerTable.MAX_PLAYERS, Integer.BYTES));
    for (int id = 0; id < limit; id++) {
      if (a.flag("player", players[id] != null)) {
        pass(a, id, table, entities);
      }
    }
  }

  private void pass(Archive a, int id, PlayerTable table, SavedEntities entities) {
    String name = a.text("name", players[id] == null ? "" : players[id].name(), MAX_NAME);
    String account = a.text("account", a.reads() ? "" : players[id].account, Newcomer.MAX_ACCOUNT);
    if (a.reads()) {
      HostPlayer known = table.participant(id);
      boolean same = known != null && known.name().equals(name) && known.account.equals(account);
      players[id] = same ? known : table.create(id, name, account);
    }
    int least = Integer.MIN_VALUE;
    int most = Integer.MAX_VALUE;
    int body = bodies[id] == null ? -1 : bodies[id].id();
    body = a.integer("body of player", body, -1, entities.capacity - 1);
    a.require(body < 0 || entities.entities[body] != null, "player=" + id + " has no body=" + body);
    bodies[id] = body < 0 ? null : entities.entities[body];
    scores[id] = a.integer("score", scores[id], least, most);
    teams[id] = a.integer("team", teams[id], least, most);
    standings[id] = a.integer("role, readiness and colour", standings[id], 0, most);
    a.require(HostPlayer.isStanding(standings[id]), "player=" + id + " standing=" + standings[id]);
    a.require(
        body < 0 || !HostPlayer.watches(standings[id]),
        "player=" + id + " watches and has body=" + body);
    inputs[id] = a.bits("input", inputs[id]);
    viewDelays[id] = a.integer("view delay", viewDelays[id], 0, HostPlayer.MAX_VIEW_DELAY);
    fields.pass(a, Scope.PLAYER, id);
  }
}
