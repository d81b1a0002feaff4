package carom.client.prediction;

import carom.net.snapshot.exact.RelayedInputs;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import java.util.Arrays;

/**
 * The inputs of all players by tick: the own ones as they were sampled, or as the server replaced
 * them when they came too late; those of others as the server relayed them, and predicted ones
 * until it does. One prediction's; allocates once for each other player.
 */
final class PlayerInputs {
  private final SimulationHost simulation;
  private final HostPlayer player;
  private final SnapshotRecords records;
  private final int mask;

  /** Time for which a player's last known input is repeated, fading, ticks; as the server does. */
  private final int holdTicks;

  private final long[] sampled;
  private final int[] ownTick;

  /**
   * The own inputs that the server takes, as far as is known: those sampled, or what replaced them.
   */
  private final long[] own;

  /** The own input each tick was simulated with. */
  private final long[] ownUsed;

  /** The newest tick whose own input is replaced. */
  private int newestReplaced = -1;

  private long last;
  private int first = Integer.MAX_VALUE;
  private int newest = -1;

  /** By player: the input each tick was simulated with; null for a player that was never near. */
  private final long[][] used = new long[SimulationHost.MAX_PLAYERS][];

  /**
   * Creates an empty history.
   *
   * @param player the own one
   * @param ticks to keep; a power of two
   */
  public PlayerInputs(
      SimulationHost simulation, HostPlayer player, SnapshotRecords records, int ticks) {
    this.simulation = simulation;
    this.player = player;
    this.records = records;
    mask = ticks - 1;
    holdTicks = Input.holdTicks(simulation.tickRate());
    sampled = new long[ticks];
    own = new long[ticks];
    ownUsed = new long[ticks];
    ownTick = new int[ticks];
    Arrays.fill(ownTick, -1);
  }

  /** Stores the own input of a tick. */
  public void put(int tick, long input) {
    sampled[tick & mask] = input;
    own[tick & mask] = input;
    ownTick[tick & mask] = tick;
    last = input;
    first = Math.min(first, tick);
    newest = Math.max(newest, tick);
  }

  /**
   * Replaces the own input of a tick at which it had not arrived. The server took the newest one
   * that had, while that held, and then let it fade.
   *
   * @param newest tick of that input, before {@code tick}
   * @param held ticks for which it was said to hold
   */
  public void replace(int tick, int newest, int held) {
    if (!has(tick) || !has(newest)) {
      return;
    }
    int missing = Math.max(0, tick - newest - held);
    own[tick & mask] = Input.faded(sampled[newest & mask], missing, holdTicks);
    newestReplaced = Math.max(newestReplaced, tick);
  }

  /** Returns whether the own input of exactly this tick was sampled. */
  public boolean has(int tick) {
    return ownTick[tick & mask] == tick;
  }

  /** Returns the own input that counts in a tick; for a tick without one, the last input. */
  public long at(int tick) {
    return has(tick) ? own[tick & mask] : tick < first ? 0 : last;
  }

  /** Returns the newest tick with an own input, or -1. */
  public int newest() {
    return newest;
  }

  /**
   * Sets the inputs of all players for a tick.
   *
   * @param input the own one
   * @param repeat whether all get the inputs with which the tick was simulated before
   */
  public void apply(int tick, long input, boolean repeat) {
    if (!repeat) {
      ownUsed[tick & mask] = input;
    }
    player.input().unpack(ownUsed[tick & mask]);
    for (int id = 0; id < simulation.playerCapacity(); id++) {
      HostPlayer other = simulation.player(id);
      if (other == null || other == player) {
        continue;
      }
      if (used[id] == null) {
        used[id] = new long[mask + 1];
      } else if (repeat) {
        other.input().unpack(used[id][tick & mask]);
        continue;
      }
      long best = relayedOrPredicted(id, tick);
      other.input().unpack(best);
      used[id][tick & mask] = best;
    }
  }

  /**
   * Sets the buttons of the tick before for the one after a tick whose state is the server's, as
   * far as the inputs of that tick are known.
   */
  public void correct(int tick) {
    player.input().before((int) at(tick));
    for (int id = 0; id < simulation.playerCapacity(); id++) {
      HostPlayer other = simulation.player(id);
      if (other != null && other != player) {
        other.input().before((int) relayedOrPredicted(id, tick));
      }
    }
  }

  /**
   * Returns a relayed input or, before it arrives, the last one known. That is repeated for as long
   * as it is known to have lasted, and then fades tick by tick: a player who has run for half a
   * second goes on, and one who turns all the time will turn.
   */
  private long relayedOrPredicted(int id, int tick) {
    RelayedInputs relayed = records.inputs();
    if (relayed.knows(id, tick)) {
      return relayed.at(id, tick);
    }
    int known = relayed.newestBefore(id, tick);
    if (known < 0) {
      return 0;
    }
    int lasted = 0;
    while (lasted < Math.min(holdTicks, tick - known)
        && relayed.knows(id, known - lasted - 1)
        && relayed.at(id, known - lasted - 1) == relayed.at(id, known)) {
      lasted++;
    }
    return Input.faded(relayed.at(id, known), tick - known - lasted, holdTicks);
  }

  /**
   * Returns whether the real inputs of all players that have a body are known for a tick. What is
   * pressed in the next one depends on them.
   */
  public boolean areKnown(int tick) {
    RelayedInputs relayed = records.inputs();
    for (int id = 0; id < simulation.playerCapacity(); id++) {
      HostPlayer other = simulation.player(id);
      if (other != null && other != player && other.entity() != null && !relayed.knows(id, tick)) {
        return false;
      }
    }
    return has(tick);
  }

  /**
   * Returns whether a tick was simulated with the real inputs of all players that have a body, as
   * far as they are known by now: none of them was predicted.
   */
  public boolean areConfirmed(int tick) {
    if (!areKnown(tick) || ownUsed[tick & mask] != own[tick & mask]) {
      return false;
    }
    for (int id = 0; id < simulation.playerCapacity(); id++) {
      HostPlayer other = simulation.player(id);
      boolean hasBody = other != null && other != player && other.entity() != null;
      if (hasBody && (used[id] == null || records.inputs().at(id, tick) != used[id][tick & mask])) {
        return false;
      }
    }
    return true;
  }

  /**
   * Returns the first tick that was simulated with a mispredicted input.
   *
   * @param after tick before the first one to look at
   * @param upTo last tick to look at
   * @return the tick, or {@link Integer#MAX_VALUE} if there is none
   */
  public int firstMispredicted(int after, int upTo) {
    RelayedInputs relayed = records.inputs();
    int first = firstReplaced(after, Math.min(upTo, newestReplaced));
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

  private int firstReplaced(int after, int upTo) {
    for (int tick = after + 1; tick <= upTo; tick++) {
      if (has(tick) && ownUsed[tick & mask] != own[tick & mask]) {
        return tick;
      }
    }
    return Integer.MAX_VALUE;
  }
}
