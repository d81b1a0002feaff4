package carom.server.prediction;

import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.exact.NearState;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.exact.UpdateDelivery;
import carom.net.snapshot.ledger.DatagramLedger;
import carom.sim.SimulationHost;
import carom.sim.ruling.InterferenceLog;

/**
 * The exact update of one session: the state of the predicted set at one tick, the base, told to
 * the client in parts. The twin of the client's {@code NearUpdate}, which puts the parts together.
 *
 * <p>An update tells the entities that the client doesn't know exactly: newcomers and what they
 * struck, entities with which the game interfered in the base tick by more than rulings, and what
 * the update before told, if that may be lost. Or it tells all of them.
 *
 * <pre>
 *             begin                   last row sent                  all acknowledged
 *   ┌──────┐         ┌─────────────┐                 ┌────────────┐
 *   │ NONE │────────►│ SENDING     │────────────────►│ SENT       │───► NONE, some more entities
 *   └──────┘         │ the list is │                 │ the list   │                may be near
 *                    │ frozen      │                 │ may change │◄──┐
 *                    └─────────────┘                 └────────────┘   │ last row sent
 *                      │         │                     │  part lost   │
 *     an entity of the │         │ older than          │ ┌────────────┴───┐
 *     list is gone     ▼         │ MOST_AGE ticks      └►│ RESENDING      │
 *                    NONE        ▼                       │ list may change│
 *                    NONE, half as many                  └────────────────┘
 *                    entities may be near
 *
 *   SENT, RESENDING: begin starts another update, which replaces this one. Older than MOST_AGE,
 *   SENT ends in NONE, and RESENDING as SENDING does.
 * </pre>
 *
 * <p>The room's thread; allocates only to grow.
 */
final class ExactUpdate {
  private final SimulationHost simulation;
  private final InterferenceLog interference;
  private final UpdateRows rows;
  private final UpdateDelivery delivery;
  private final DatagramLedger ledger;

  /** The list that this update, or the last one, belongs to. */
  private final KeyList members = new KeyList();

  /** The entities whose exact state was told to the client, or follows from what was told. */
  private final KeyList known = new KeyList();

  /** The entities that the update before this one told, which perhaps has not arrived. */
  private final KeyList unconfirmed = new KeyList();

  private boolean underWay;
  private int baseTick;

  /** Differences after this tick and before {@link #beyondHelpUntil} are put right by none. */
  private int beyondHelpAfter = Integer.MAX_VALUE;

  private int beyondHelpUntil;

  /**
   * When the update before this one was sent as a whole; no tick is later if this one tells all.
   */
  private int earlierSentTick = Integer.MAX_VALUE;

  /** True if the last update was given up before all of it arrived. */
  private boolean givenUp;

  ExactUpdate(SimulationHost simulation, int viewer, SnapshotEncoder encoder) {
    rows = new UpdateRows(viewer);
    delivery = encoder.updates();
    ledger = encoder.ledger();
    this.simulation = simulation;
    interference = simulation.interference();
  }

  /** Returns the list that places in the update refer to. */
  KeyList members() {
    return members;
  }

  /** Returns whether the next snapshot should carry a part. */
  boolean isDue() {
    return underWay && delivery.isDue();
  }

  /** Returns whether the list must stay as it is, because not all has been sent yet. */
  boolean isSending() {
    return isDue() && !delivery.wasSentOnce();
  }

  /**
   * Returns whether the client lacks a part of the update under way, and nothing that this update
   * doesn't tell: then the update will put right what the client has wrong.
   */
  boolean isHelping() {
    return underWay && !delivery.isEarlierPartLost();
  }

  /**
   * Returns whether no update that was begun so far can put right a difference at a tick, though
   * two have been begun since. Without this, a set that changes more often than news from the
   * client arrive would explain every difference for ever.
   */
  boolean isBeyondHelp(int tick) {
    return tick > beyondHelpAfter && tick < beyondHelpUntil;
  }

  /** Returns whether the exact state of an entity was told, or follows from what was told. */
  boolean isKnown(int key) {
    return known.find(key, 0) >= 0;
  }

  /** Returns whether the update under way is too old to be of use. */
  boolean isTooOld() {
    return underWay && simulation.tick() - baseTick > NearState.MOST_AGE;
  }

  /**
   * Sends the parts again that haven't arrived. Call it when the client has a state that is newer
   * than all of them, and lacks them: they are lost, or too late to be waited for.
   */
  void sendMissingAgain() {
    delivery.sendMissingAgain();
  }

  /** Returns the tick at which the last update was sent as a whole, or -1. */
  int sentTick() {
    return delivery.sentTick();
  }

  /** Returns the number of rows that are still to be sent, lost ones included. */
  int waitingRows() {
    return underWay ? delivery.dueRows() : 0;
  }

  /** Ends the update, whether it has arrived or not. */
  void cancel() {
    givenUp |= underWay;
    underWay = false;
  }

  /** Ends the update and forgets what the client knows. */
  void reset() {
    delivery.clear();
    members.clear();
    known.clear();
    underWay = false;
    givenUp = false;
    beyondHelpAfter = Integer.MAX_VALUE;
    earlierSentTick = Integer.MAX_VALUE;
  }

  /**
   * Begins an update with the present state as its base, in place of one that is under way.
   *
   * @param near the predicted set, in the order of the world
   * @param all whether all of it is told
   */
  void begin(EntityList near, boolean all) {
    boolean repeats = isDoubtful();
    noteHelp(all);
    noteUnconfirmed(repeats);
    if (all) {
      delivery.forgetEarlier();
    } else if (underWay && !repeats) {
      delivery.keepEarlier();
    }
    underWay = true;
    givenUp = false;
    baseTick = simulation.tick();
    members.clear();
    rows.begin(near, simulation);
    for (int i = 0, likely = 0; i < near.count(); i++) {
      int key = near.key(i);
      members.add(key);
      int at = known.find(key, likely);
      likely = at < 0 ? likely : at + 1;
      boolean isNew = at < 0 || unconfirmed.find(key, 0) >= 0;
      if (all || isNew || isChanged(near, i)) {
        rows.tell(i);
      }
      if (isNew && near.get(i).body().awake()) {
        rows.tellIsland(i);
      }
    }
    rows.end();
    delivery.begin(rows.count());
  }

  /**
   * Notes which differences two updates didn't put right. The one that begins may yet do so with
   * those since the base of the one before, which it repeats, or whose list kept a newcomer out.
   */
  private void noteHelp(boolean all) {
    beyondHelpAfter = all ? Integer.MAX_VALUE : earlierSentTick;
    beyondHelpUntil = baseTick;
    earlierSentTick = all ? Integer.MAX_VALUE : delivery.sentTick();
  }

  private boolean isChanged(EntityList near, int place) {
    return interference.lastUntoldTick(near.get(place)) == baseTick;
  }

  /** Returns whether a part of the last update may be lost: the next one should tell it again. */
  private boolean isDoubtful() {
    return givenUp || (underWay && (ledger.isLossy(simulation.tick()) || delivery.isDue()));
  }

  private void noteUnconfirmed(boolean repeats) {
    unconfirmed.clear();
    if (repeats) {
      for (int i = 0; i < rows.toldCount(); i++) {
        unconfirmed.add(members.get(rows.told(i)));
      }
    }
  }

  /**
   * Prepares a snapshot: writes the next part, if one is due and there is room.
   *
   * @param rowBits what rows may take, not positive if they must wait
   * @param out has the own body and the list
   */
  void write(int rowBits, OwnState out) {
    if (isDue()) {
      delivery.write(rows, simulation.tick() - baseTick, rowBits, out);
    } else {
      delivery.skip();
    }
  }

  /** Notes that the snapshot prepared last was sent. */
  void sent() {
    if (delivery.sentTick() == simulation.tick()) {
      known.set(members);
    }
  }

  /** Ends the update if all of it has arrived; returns whether it did. */
  boolean endIfArrived() {
    boolean arrived = underWay && delivery.hasArrived();
    underWay &= !arrived;
    return arrived;
  }
}
