package carom.sim.entity;

import carom.physics.math.SimRandom;
import carom.sim.field.FieldStore;
import carom.sim.field.Scope;
import carom.sim.message.PlayerRole;
import java.util.function.Consumer;

/**
 * The participants of a simulation by id: players and spectators. The game doesn't see spectators
 * among the players. Holds their part of the state.
 */
public final class PlayerTable {
  /** Most players at a time; ids are 0..1,023. */
  public static final int MAX_PLAYERS = 1_024;

  private final HostPlayer[] players = new HostPlayer[MAX_PLAYERS];
  private final FieldStore fields;
  private final Consumer<String> authority;
  private final Consumer<String> told;
  private final HostPlayer.Spawns spawns;

  /** Number above all ids of participants. */
  private int limit;

  /**
   * Creates an empty table.
   *
   * @param authority refuses a call, by its name, that only a server may make
   * @param told refuses a question, by its name, where clients would have to know the answer
   * @param spawns creates what players fire
   */
  PlayerTable(
      FieldStore fields,
      Consumer<String> authority,
      Consumer<String> told,
      HostPlayer.Spawns spawns) {
    this.fields = fields;
    this.authority = authority;
    this.told = told;
    this.spawns = spawns;
  }

  /** Returns the player under an id, or null when no player has it. */
  public HostPlayer get(int id) {
    HostPlayer p = participant(id);
    return p == null || p.isSpectator() ? null : p;
  }

  /** Returns the player or spectator under an id, or null when the id is free or out of range. */
  public HostPlayer participant(int id) {
    return id >= 0 && id < limit ? players[id] : null;
  }

  /** Returns the number of players, without spectators. */
  public int count() {
    int n = 0;
    for (int id = 0; id < limit; id++) {
      n += get(id) != null ? 1 : 0;
    }
    return n;
  }

  /** Returns the number of players in a team. */
  public int teamSize(int team) {
    int n = 0;
    for (int id = 0; id < limit; id++) {
      HostPlayer p = get(id);
      n += p != null && p.team() == team ? 1 : 0;
    }
    return n;
  }

  /** Returns whether there are players, and all of them are ready. */
  public boolean allReady() {
    boolean any = false;
    for (int id = 0; id < limit; id++) {
      HostPlayer p = get(id);
      if (p != null && !p.isReady()) {
        return false;
      }
      any |= p != null;
    }
    return any;
  }

  /** Returns the player with the highest score, or null if several have it. */
  public HostPlayer leader() {
    HostPlayer best = null;
    boolean alone = false;
    for (int id = 0; id < limit; id++) {
      HostPlayer p = get(id);
      if (p != null && (best == null || p.score() >= best.score())) {
        alone = best == null || p.score() > best.score();
        best = p;
      }
    }
    return alone ? best : null;
  }

  /** Returns a number above all ids of participants. */
  public int limit() {
    return limit;
  }

  /** Returns the smallest free id; {@link #MAX_PLAYERS} when there is none. */
  public int freeId() {
    int id = 0;
    while (id < limit && players[id] != null) {
      id++;
    }
    return id;
  }

  /**
   * Checks that an id can be given to a player.
   *
   * @throws IllegalStateException when it is taken or out of range
   */
  public void requireFree(int id) {
    if (id < 0 || id >= MAX_PLAYERS || participant(id) != null) {
      throw new IllegalStateException(
          "player id=" + id + " is taken or outside 0.." + (MAX_PLAYERS - 1));
    }
  }

  /** Creates a player that is in no table yet. */
  HostPlayer create(int id, String name, String account) {
    return new HostPlayer(id, name, account, fields.create(Scope.PLAYER), authority, told, spawns);
  }

  /**
   * Creates a player under an id that is free.
   *
   * @throws IllegalArgumentException if its values are none of this game
   */
  public HostPlayer add(int id, Newcomer newcomer) {
    HostPlayer player = create(id, newcomer.name(), newcomer.account());
    if (newcomer.values() != null) {
      player.fieldValues().begin(newcomer.values());
    }
    players[id] = player;
    limit = Math.max(limit, id + 1);
    return player;
  }

  /** Lets a participant play or watch, with nothing left from before but name, colour and input. */
  public void become(HostPlayer participant, PlayerRole role) {
    participant.become(role);
  }

  /** Removes the player under an id. */
  public void remove(int id) {
    players[id] = null;
    while (limit > 0 && players[limit - 1] == null) {
      limit--;
    }
  }

  /** Mixes everything that decides the players' future into a state hash. */
  public long hash(long hash) {
    long h = hash;
    for (int i = 0; i < limit; i++) {
      HostPlayer p = players[i];
      if (p != null) {
        h =
            SimRandom.mix(
                h,
                (long) p.standing() << 48
                    | (long) i << 32
                    | (p.body == null ? -1 : p.body.id()) & 0xffffffffL);
        h = SimRandom.mix(h, ((long) p.score() << 32) | (p.team() & 0xffffffffL));
        h = SimRandom.mix(h, p.input().pack() | (long) p.viewDelay() << Input.PACKED_BITS);
        if (p.input().before() != p.input().buttons()) { // equal after each step
          h = SimRandom.mix(h, p.input().before());
        }
        h = p.fieldValues().hash(h);
      }
    }
    return h;
  }

  /** Lets the buttons that all participants hold be those of the tick before. */
  public void endTick() {
    for (int i = 0; i < limit; i++) {
      if (players[i] != null) {
        players[i].input().before(players[i].input().buttons());
      }
    }
  }

  /** Copies the players' state to a saved one. */
  public void save(SavedPlayers s) {
    s.limit(limit);
    for (int i = 0; i < limit; i++) {
      HostPlayer p = players[i];
      s.players[i] = p;
      if (p != null) {
        s.bodies[i] = p.body;
        s.scores[i] = p.score();
        s.teams[i] = p.team();
        s.standings[i] = p.standing();
        s.inputs[i] = p.input().pack() | (long) p.input().before() << Input.PACKED_BITS;
        s.viewDelays[i] = p.viewDelay();
        s.fields.save(p.fieldValues(), i);
      }
    }
  }

  /** Takes the players' state from a saved one. */
  public void restore(SavedPlayers s) {
    int before = limit;
    limit = s.limit;
    for (int i = 0; i < Math.max(before, limit); i++) {
      HostPlayer p = i < limit ? s.players[i] : null;
      players[i] = p;
      if (p != null) {
        p.body = s.bodies[i];
        p.restore(s.scores[i], s.teams[i], s.standings[i], s.inputs[i], s.viewDelays[i]);
        s.fields.restore(p.fieldValues(), i);
      }
    }
  }
}
