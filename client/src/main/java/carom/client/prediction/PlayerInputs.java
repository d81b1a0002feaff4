package carom.client.prediction;

import carom.net.snapshot.relay.RelayedInputs;
import carom.sim.Input;
import carom.sim.Player;
import carom.sim.Simulation;
import java.util.Arrays;

/**
 * What players do in each tick: the own inputs as they were given, those of others as the server
 * relayed them, or as foreseen until it does. One prediction's; allocates once for each other
 * player.
 */
final class PlayerInputs {
  /** For how long a player's last known input is repeated, fading. */
  private static final int REPEAT_TICKS = 30;

  private final Simulation simulation;
  private final Player player;
  private final Records records;
  private final int mask;
  private final long[] own;
  private final int[] ownTick;
  private long last;
  private int first = Integer.MAX_VALUE;
  private int newest = -1;

  /** By player: the input each tick was computed with; null for who was never near. */
  private final long[][] used = new long[Simulation.MAX_PLAYERS][];

  /**
   * Knows nothing yet.
   *
   * @param player the own one
   * @param ticks kept; a power of two
   */
  PlayerInputs(Simulation simulation, Player player, Records records, int ticks) {
    this.simulation = simulation;
    this.player = player;
    this.records = records;
    mask = ticks - 1;
    own = new long[ticks];
    ownTick = new int[ticks];
    Arrays.fill(ownTick, -1);
  }

  /** Notes the own input of a tick. */
  void put(int tick, long input) {
    own[tick & mask] = input;
    ownTick[tick & mask] = tick;
    last = input;
    first = Math.min(first, tick);
    newest = Math.max(newest, tick);
  }

  /** Whether the own input of that very tick was given. */
  boolean has(int tick) {
    return ownTick[tick & mask] == tick;
  }

  /** The own input of a tick; one that wasn't given counts as the last one. */
  long at(int tick) {
    return has(tick) ? own[tick & mask] : tick < first ? 0 : last;
  }

  /** The newest tick with an own input, or -1. */
  int newest() {
    return newest;
  }

  /**
   * Steers all players for a tick.
   *
   * @param input the own one
   * @param again whether others do what they did when the tick was computed last
   */
  void steer(int tick, long input, boolean again) {
    player.input().unpack(input);
    for (int id = 0; id < simulation.playerCapacity(); id++) {
      Player other = simulation.player(id);
      if (other == null || other == player) {
        continue;
      }
      if (used[id] == null) {
        used[id] = new long[mask + 1];
      } else if (again) {
        other.input().unpack(used[id][tick & mask]);
        continue;
      }
      long foreseen = foresee(id, tick);
      other.input().unpack(foreseen);
      used[id][tick & mask] = foreseen;
    }
  }

  /** What a player did, or probably does: what it did last, and a little less each tick. */
  private long foresee(int id, int tick) {
    RelayedInputs relayed = records.inputs();
    if (relayed.knows(id, tick)) {
      return relayed.at(id, tick);
    }
    int known = relayed.newestBefore(id, tick);
    return known < 0 ? 0 : Input.faded(relayed.at(id, known), tick - known, REPEAT_TICKS);
  }

  /**
   * Whether a tick was computed with what all players with a body really did, as far as it is known
   * by now: nothing was foreseen.
   */
  boolean areTrue(int tick) {
    RelayedInputs relayed = records.inputs();
    for (int id = 0; id < simulation.playerCapacity(); id++) {
      Player other = simulation.player(id);
      if (other == null || other == player || other.body() == null) {
        continue;
      }
      if (used[id] == null
          || !relayed.knows(id, tick)
          || relayed.at(id, tick) != used[id][tick & mask]) {
        return false;
      }
    }
    return has(tick);
  }

  /** The first tick in which a player did something else than was foreseen; huge when none. */
  int firstWrong(int after, int upTo) {
    RelayedInputs relayed = records.inputs();
    int first = Integer.MAX_VALUE;
    for (int id = 0; id < simulation.playerCapacity(); id++) {
      if (used[id] == null || simulation.player(id) == null || simulation.player(id) == player) {
        continue;
      }
      int last = Math.min(Math.min(upTo, first - 1), relayed.newestTick(id));
      for (int tick = after + 1; tick <= last; tick++) {
        if (relayed.knows(id, tick) && relayed.at(id, tick) != used[id][tick & mask]) {
          first = tick;
          break;
        }
      }
    }
    return first;
  }
}
