package carom.server.prediction;

import carom.net.snapshot.exact.OwnState;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import java.util.Arrays;
import java.util.function.Predicate;

/**
 * Chooses the players whose inputs are relayed to one client: those whose bodies it predicts. The
 * inputs of a player whose body is hidden from the client are not relayed.
 *
 * <p>Each comes with the tick since which it is relayed without a pause: what it did before is none
 * of this client's business.
 *
 * <p>The room's thread; allocates only to grow.
 */
final class RelayChooser {
  private static final int NEVER = -1_000;

  private final Predicate<HostEntity> mayKnow;

  /** The last tick at which a player's inputs were relayed, by player id. */
  private int[] lastTick = {};

  /** The tick since which they were relayed without a pause, by player id. */
  private int[] firstTick = {};

  RelayChooser(Predicate<HostEntity> mayKnow) {
    this.mayKnow = mayKnow;
  }

  /**
   * Adds the owner of an entity that is near, if its inputs may be relayed.
   *
   * @param owner may be null
   * @param to the client's player
   * @param before the tick of the capture before this one
   * @param tick the tick of this capture
   * @param out receives it; at most {@link OwnState#MAX_RELAYED}
   */
  void offer(HostPlayer owner, HostPlayer to, int before, int tick, OwnState out) {
    if (owner == null || owner == to || out.relayed().size() >= OwnState.MAX_RELAYED) {
      return;
    }
    if (owner.entity() != null && !mayKnow.test(owner.entity())) {
      return;
    }
    grow(owner.id());
    int last = lastTick[owner.id()];
    if (last != tick) { // else another entity of its own was near, too
      firstTick[owner.id()] = last == before ? firstTick[owner.id()] : tick;
      lastTick[owner.id()] = tick;
      out.relay(owner.id(), firstTick[owner.id()]);
    }
  }

  private void grow(int id) {
    if (lastTick.length <= id) {
      int size = lastTick.length;
      lastTick = Arrays.copyOf(lastTick, Math.max(2 * size, id + 1));
      Arrays.fill(lastTick, size, lastTick.length, NEVER);
      firstTick = Arrays.copyOf(firstTick, lastTick.length);
    }
  }
}
