package carom.client.prediction.received;

import carom.net.snapshot.exact.NearState;
import carom.physics.rows.BodyRow;
import carom.sim.Rulings;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.near.Neighbourhood;
import carom.sim.ruling.Ruling;

/**
 * What the server told of what the game's rules did to near bodies. The predicted simulation asks
 * for it in every step, also when it computes a tick again. One prediction's; allocates only to
 * grow.
 */
public final class ReceivedRulings implements Rulings {
  /** Value of {@link #takeFirst} if there is nothing new. */
  public static final int NONE = Integer.MAX_VALUE;

  /** Most rulings that are kept; the oldest are forgotten. A power of two. */
  private static final int MOST = 512;

  private final Ruling[] rulings = new Ruling[MOST];
  private int next;
  private int first = NONE;
  private int newestTick = -1;
  private final Ruling read = new Ruling();
  private final int[] row = new int[BodyRow.INTS];
  private long received;

  /** Creates a store without rulings. */
  public ReceivedRulings() {}

  /**
   * Adds the rulings of a snapshot. Those that are known already, or make no sense, are ignored.
   */
  public void add(NearState near, int stateTick) {
    for (int i = 0; i < near.rulings(); i++) {
      read.tick = stateTick - near.rulingAge(i);
      read.afterStep = near.isRulingAfterStep(i);
      read.key = near.key(near.rulingPlace(i));
      read.mask = near.rulingMask(i);
      for (int word = 0; word < Ruling.WORDS; word++) {
        read.row[BodyRow.MOTION + word] = near.rulingWord(i, word);
      }
      if (read.isSane() && !isKnown()) {
        put();
      }
    }
  }

  private boolean isKnown() {
    for (Ruling known : rulings) {
      if (known != null && known.isSameMoment(read)) {
        return true;
      }
    }
    return false;
  }

  private void put() {
    int slot = next++ & (MOST - 1);
    if (rulings[slot] == null) {
      rulings[slot] = new Ruling();
    }
    rulings[slot].set(read);
    first = Math.min(first, read.tick);
    newestTick = Math.max(newestTick, read.tick);
    received++;
  }

  /** Returns the first tick of a ruling that came since the last call, or {@link #NONE}. */
  public int takeFirst() {
    int tick = first;
    first = NONE;
    return tick;
  }

  /** Returns how many came. */
  public long received() {
    return received;
  }

  @Override
  public void beforeStep(Simulation s) {
    apply(s, false);
  }

  @Override
  public void afterStep(Simulation s) {
    apply(s, true);
  }

  private void apply(Simulation s, boolean afterStep) {
    if (s.tick() > newestTick) {
      return;
    }
    for (Ruling ruling : rulings) {
      if (ruling == null || ruling.tick != s.tick() || ruling.afterStep != afterStep) {
        continue;
      }
      Entity e = s.entity(Neighbourhood.id(ruling.key));
      if (e != null && e.generation() == Neighbourhood.generation(ruling.key)) {
        ruling.apply(e, s.archetypes(), row);
      }
    }
  }
}
