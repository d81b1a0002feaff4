package carom.client.prediction;

import carom.net.snapshot.exact.NearState;
import carom.physics.Joint;
import carom.physics.rows.BodyRow;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.JointTable;
import carom.sim.near.Neighbourhood;
import carom.sim.ruling.Ruling;
import carom.sim.ruling.Rulings;
import java.util.Arrays;
import java.util.function.Consumer;

/**
 * Keeps what the server told of what the game did to near bodies and this client can't compute. The
 * predicted simulation asks for it in every step, also when it computes a tick again. One
 * prediction's; allocates only to grow.
 */
final class ReceivedRulings implements Rulings {
  /** Value of {@link #takeFirst} if there is nothing new. */
  public static final int NONE = Integer.MAX_VALUE;

  /** Most rulings that are kept; the oldest are forgotten. A power of two. */
  private static final int MOST = 512;

  /** Ticks for which guesses are remembered; a power of two. */
  private static final int GUESS_TICKS = 256;

  private static final Ruling.Moment[] MOMENTS = Ruling.Moment.values();

  private final Ruling[] rulings = new Ruling[MOST];
  private int next;

  /** The number of rulings that had come when {@link #takeFirst} was called last. */
  private int taken;

  private int newestTick = -1;
  private final Ruling read = new Ruling();
  private final int[] row = new int[BodyRow.INTS];
  private final SimulationHost s;
  private final int ownId;

  /** By tick: the last one in which the effect of an input was a guess. */
  private final int[] guessed = new int[GUESS_TICKS];

  private Joint<HostEntity> joint;
  private int wantedJoint;
  private JointTable<HostEntity> table;
  private final Consumer<Joint<HostEntity>> lookAt = this::lookAt;

  /**
   * Creates a store without rulings.
   *
   * @param s applies them
   * @param ownId the own player's id, whose fields are known
   */
  public ReceivedRulings(SimulationHost s, int ownId) {
    this.s = s;
    this.ownId = ownId;
    Arrays.fill(guessed, -1);
  }

  /**
   * Adds the rulings of a snapshot. Those that are known already, or make no sense, are ignored.
   */
  public void add(NearState near, int stateTick) {
    for (int i = 0; i < near.rulings(); i++) {
      read.tick = stateTick - near.rulingAge(i);
      read.moment = MOMENTS[near.rulingMoment(i)];
      read.joint = near.rulingJoint(i);
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
    newestTick = Math.max(newestTick, read.tick);
  }

  /**
   * Returns the first tick of a ruling that came since the last call, or {@link #NONE}.
   *
   * @param knownTick a tick at which all was as the server has it: rulings up to it are included
   *     and don't count; -1 for none
   */
  public int takeFirst(int knownTick) {
    int first = NONE;
    for (int i = Math.max(taken, next - MOST); i < next; i++) {
      int tick = rulings[i & (MOST - 1)].tick;
      first = tick > knownTick ? Math.min(first, tick) : first;
    }
    taken = next;
    return first;
  }

  @Override
  public void beforeStep() {
    guessed[s.tick() & GUESS_TICKS - 1] = -1;
    apply(Ruling.Moment.BEFORE_STEP, null);
  }

  @Override
  public boolean input(HostPlayer player) {
    if (player.id() == ownId || s.tick() > newestTick || !isTold(s.tick(), player.entity())) {
      return false;
    }
    apply(Ruling.Moment.INPUT, player);
    return true;
  }

  private boolean isTold(int tick, HostEntity body) {
    int key = Neighbourhood.key(body.id(), body.generation());
    for (Ruling ruling : rulings) {
      if (ruling != null
          && ruling.tick == tick
          && ruling.moment == Ruling.Moment.INPUT
          && ruling.key == key
          && ruling.joint == Ruling.BODY) {
        return true;
      }
    }
    return false;
  }

  @Override
  public void readHidden(HostPlayer player, boolean untold) {
    if (untold || player.id() != ownId) {
      guessed[s.tick() & GUESS_TICKS - 1] = s.tick();
    }
  }

  /**
   * Returns whether the effect of an input was guessed when a tick was computed last: it read what
   * this client isn't told.
   */
  public boolean isGuessed(int tick) {
    return guessed[tick & GUESS_TICKS - 1] == tick;
  }

  @Override
  public void afterStep() {
    apply(Ruling.Moment.AFTER_STEP, null);
  }

  /** Applies the rulings of a moment; of those in inputs only the ones of a player. */
  private void apply(Ruling.Moment moment, HostPlayer player) {
    if (s.tick() > newestTick) {
      return;
    }
    for (Ruling ruling : rulings) {
      if (ruling == null || ruling.tick != s.tick() || ruling.moment != moment) {
        continue;
      }
      HostEntity e = s.entity(Neighbourhood.id(ruling.key));
      if (e == null
          || e.generation() != Neighbourhood.generation(ruling.key)
          || (player != null && e.ownerId() != player.id())) {
        continue;
      }
      if (ruling.joint == Ruling.BODY) {
        ruling.apply(e, s.archetypes(), row);
      } else {
        applyToJoint(e, ruling);
      }
    }
  }

  private void applyToJoint(HostEntity e, Ruling ruling) {
    joint = null;
    wantedJoint = ruling.joint;
    table = s.joints();
    e.body().forEachJoint(lookAt);
    if (joint != null) {
      ruling.apply(joint, row);
    }
  }

  private void lookAt(Joint<HostEntity> candidate) {
    boolean isWanted = JointTable.index(table.key(candidate.index())) == wantedJoint;
    joint = isWanted ? candidate : joint;
  }
}
