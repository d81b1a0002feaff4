package carom.sim;

import carom.sim.random.SimRandom;

/**
 * The participants of a simulation by id: players and spectators. The game doesn't see spectators
 * among the players. Holds their part of the state.
 */
final class PlayerTable {
  private final Player[] players = new Player[Simulation.MAX_PLAYERS];

  /** Number above all ids of participants. */
  private int limit;

  /** Returns the player under an id, or null when no player has it. */
  Player get(int id) {
    Player p = participant(id);
    return p == null || p.isSpectator() ? null : p;
  }

  /** Returns the player or spectator under an id, or null when the id is free or out of range. */
  Player participant(int id) {
    return id >= 0 && id < limit ? players[id] : null;
  }

  /** Returns the number of players, without spectators. */
  int count() {
    int n = 0;
    for (int id = 0; id < limit; id++) {
      n += get(id) != null ? 1 : 0;
    }
    return n;
  }

  /** Returns the number of players in a team. */
  int teamSize(int team) {
    int n = 0;
    for (int id = 0; id < limit; id++) {
      Player p = get(id);
      n += p != null && p.team() == team ? 1 : 0;
    }
    return n;
  }

  /** Returns whether there are players, and all of them are ready. */
  boolean allReady() {
    boolean any = false;
    for (int id = 0; id < limit; id++) {
      Player p = get(id);
      if (p != null && !p.isReady()) {
        return false;
      }
      any |= p != null;
    }
    return any;
  }

  /** Returns a number above all ids of participants. */
  int limit() {
    return limit;
  }

  /** Returns the smallest free id; {@link Simulation#MAX_PLAYERS} when there is none. */
  int freeId() {
    int id = 0;
    while (id < limit && players[id] != null) {
      id++;
    }
    return id;
  }

  /** Adds a player under its own id. */
  void add(Player player) {
    players[player.id()] = player;
    limit = Math.max(limit, player.id() + 1);
  }

  /** Removes the player under an id. */
  void remove(int id) {
    players[id] = null;
    while (limit > 0 && players[limit - 1] == null) {
      limit--;
    }
  }

  /** Mixes everything that decides the players' future into a state hash. */
  long hash(long hash) {
    long h = hash;
    for (int i = 0; i < limit; i++) {
      Player p = players[i];
      if (p != null) {
        h =
            SimRandom.mix(
                h,
                (long) p.standing() << 48
                    | (long) i << 32
                    | (p.body == null ? -1 : p.body.id()) & 0xffffffffL);
        h = SimRandom.mix(h, ((long) p.score() << 32) | (p.team() & 0xffffffffL));
        h = SimRandom.mix(h, p.input().pack() | (long) p.viewDelay() << Input.PACKED_BITS);
        h = p.fieldValues().hash(h);
      }
    }
    return h;
  }

  /** Copies the players' state to a saved one. */
  void save(SimState s) {
    s.limitPlayers(limit);
    for (int i = 0; i < limit; i++) {
      Player p = players[i];
      s.players[i] = p;
      if (p != null) {
        s.bodies[i] = p.body;
        s.scores[i] = p.score();
        s.teams[i] = p.team();
        s.standings[i] = p.standing();
        s.inputs[i] = p.input().pack();
        s.viewDelays[i] = p.viewDelay();
        s.fields.save(p.fieldValues(), i);
      }
    }
  }

  /** Takes the players' state from a saved one. */
  void restore(SimState s) {
    int before = limit;
    limit = s.playerLimit;
    for (int i = 0; i < Math.max(before, limit); i++) {
      Player p = i < limit ? s.players[i] : null;
      players[i] = p;
      if (p != null) {
        p.body = s.bodies[i];
        p.restore(s.scores[i], s.teams[i], s.standings[i], s.inputs[i], s.viewDelays[i]);
        s.fields.restore(p.fieldValues(), i);
      }
    }
  }
}
