package carom.sim;

import carom.sim.random.SimRandom;

/** The players of a simulation by id, and their part of its state. */
final class PlayerTable {
  private final Player[] players = new Player[Simulation.MAX_PLAYERS];

  /** Number above all ids of players. */
  private int limit;

  /** Returns the player under an id, or null when the id is free or out of range. */
  Player get(int id) {
    return id >= 0 && id < limit ? players[id] : null;
  }

  /** Returns a number above all ids of players. */
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
                h, ((long) i << 32) | ((p.body == null ? -1 : p.body.id()) & 0xffffffffL));
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
        p.restore(s.scores[i], s.teams[i], s.inputs[i], s.viewDelays[i]);
        s.fields.restore(p.fieldValues(), i);
      }
    }
  }
}
