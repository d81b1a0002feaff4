package carom.sim;

import carom.physics.WorldState;

/**
 * A saved {@link Simulation}: arrays of its own, reused from save to save. Belongs to the
 * simulation that filled it; its contents are nobody else's business.
 */
public final class SimState {
  final Simulation owner;
  WorldState world;
  int tick;
  long random;
  int[] memory = {};
  int playerLimit;
  final Player[] players = new Player[Simulation.MAX_PLAYERS];
  final Entity[] bodies = new Entity[Simulation.MAX_PLAYERS];
  final int[] scores = new int[Simulation.MAX_PLAYERS];
  final int[] teams = new int[Simulation.MAX_PLAYERS];
  final long[] inputs = new long[Simulation.MAX_PLAYERS];
  final int[] viewDelays = new int[Simulation.MAX_PLAYERS];
  final int[] playerMemory = new int[Simulation.MAX_PLAYERS * Player.MEMORY_SIZE];
  int entityCount;
  int entityCapacity;
  Entity[] entities = {};
  int[] tags = {};
  int[] teleports = {};
  byte[] generations = {};
  PoseHistory history;

  SimState(Simulation owner) {
    this.owner = owner;
  }

  /** The tick the state belongs to. */
  public int tick() {
    return tick;
  }
}
