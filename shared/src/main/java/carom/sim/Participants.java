package carom.sim;

import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Newcomer;
import carom.sim.entity.PlayerTable;
import carom.sim.message.PlayerRole;
import carom.sim.phase.Phase;

/**
 * Lets participants come, go, and change between playing and watching. It tells the game, and
 * removes what goes with a player who leaves.
 */
final class Participants {
  private final SimulationHost simulation;
  private final SimParts parts;
  private final PlayerTable players;
  private final Spawner spawner;

  /** The player who is becoming a spectator; null mostly. */
  private HostPlayer retiring;

  Participants(SimulationHost simulation, SimParts parts, Spawner spawner) {
    this.simulation = simulation;
    this.parts = parts;
    this.spawner = spawner;
    players = parts.players;
  }

  /** Adds a player, as {@link SimulationHost#join(String)} says. */
  HostPlayer join(String name) {
    int id = players.freeId();
    if (id == PlayerTable.MAX_PLAYERS) {
      throw new IllegalStateException("players=" + id + " is the limit; " + name + " can't join");
    }
    return join(id, Newcomer.stranger(name), 0, 0);
  }

  /** Adds a player, as {@link SimulationHost#join(int, Newcomer, int, int)} says. */
  HostPlayer join(int id, Newcomer newcomer, int team, int score) {
    parts.phases.requireAuthority("join");
    players.requireFree(id);
    if (!parts.journals.isEmpty() && (team != 0 || score != 0)) {
      throw new IllegalStateException(
          "a journal can't tell what "
              + newcomer.name()
              + " brings: team="
              + team
              + " score="
              + score);
    }
    parts.journals.joining(simulation, id, newcomer);
    boolean full = players.count() >= parts.game.maxPlayers();
    HostPlayer player = players.add(id, newcomer);
    if (full) {
      players.become(player, PlayerRole.SPECTATOR);
      BuiltInMessages.tell(simulation, player, BuiltInMessages.refusalWhenFull(simulation));
      return player;
    }
    player.team(team);
    player.score(score);
    enter(player);
    return player;
  }

  /** Adds a spectator, as {@link SimulationHost#joinAsSpectator} says. */
  HostPlayer joinAsSpectator(int id, Newcomer newcomer) {
    parts.phases.requireAuthority("joinAsSpectator");
    players.requireFree(id);
    parts.journals.watching(simulation, id, newcomer);
    HostPlayer player = players.add(id, newcomer);
    players.become(player, PlayerRole.SPECTATOR);
    return player;
  }

  /**
   * Lets a participant play or watch, as {@link SimulationHost#role(HostPlayer, PlayerRole)} says.
   */
  void role(HostPlayer participant, PlayerRole role) {
    parts.phases.requireAuthority("role");
    if (participant == retiring) {
      throw new IllegalStateException("the role of " + participant + " can't change in Game.leave");
    }
    if (players.participant(participant.id()) != participant || participant.role() == role) {
      return;
    }
    if (isBetweenSteps()) {
      parts.journals.changing(simulation, participant.id(), role);
    }
    if (role == PlayerRole.PLAYER) {
      players.become(participant, role);
      enter(participant);
    } else {
      retiring = participant;
      try {
        retire(participant);
      } finally {
        retiring = null;
      }
      players.become(participant, role);
      parts.allFields.forgetPlayer(participant.id());
    }
  }

  /** Gives back what an account has kept, as {@link SimulationHost#keep} says. */
  void keep(HostPlayer participant, int[] values) {
    parts.phases.requireAuthority("keep");
    if (!isBetweenSteps()) {
      throw new IllegalStateException("what " + participant + " keeps can't change within a step");
    }
    if (players.participant(participant.id()) == participant) {
      parts.journals.keeping(simulation, participant.id(), values);
      participant.fieldValues().begin(values);
    }
  }

  /** Removes a participant, as {@link SimulationHost#leave} says. */
  void leave(HostPlayer player) {
    parts.phases.requireOutsidePhysics("leave");
    int id = player.id();
    if (players.participant(id) != player) {
      return;
    }
    parts.received.forget(id);
    parts.journals.leaving(simulation, id);
    if (parts.role == Role.AUTHORITY && !player.isSpectator()) {
      retire(player);
    }
    players.remove(id);
    parts.allFields.forgetPlayer(id);
  }

  /** Tells who left sensors by going between two ticks; what happens in a tick, that tells. */
  void tellVisits() {
    if (parts.role == Role.AUTHORITY && isBetweenSteps()) {
      parts.triggers.tell();
    }
  }

  private boolean isBetweenSteps() {
    return !parts.phases.isInStep() && parts.phases.now() == Phase.BETWEEN_STEPS;
  }

  /** Lets a player into the game. */
  private void enter(HostPlayer player) {
    Phase outer = parts.phases.begin(Phase.JOIN);
    try {
      parts.game.join(simulation, player);
    } finally {
      parts.phases.end(outer);
    }
    tellVisits();
  }

  /** Takes a player out of the game, with everything the player owns. */
  private void retire(HostPlayer player) {
    Phase outer = parts.phases.begin(Phase.LEAVE);
    try {
      parts.game.leave(simulation, player);
    } finally {
      parts.phases.end(outer);
    }
    for (int i = 0; i < parts.entities.capacity(); i++) {
      HostEntity entity = parts.entities.get(i);
      if (entity != null && entity.ownerId() == player.id()) {
        spawner.despawn(entity);
      }
    }
    tellVisits();
  }
}
