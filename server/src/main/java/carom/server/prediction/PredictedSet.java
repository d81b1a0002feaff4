package carom.server.prediction;

import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.exact.NearState;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.exact.RulingDelivery;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.BodyVisitor;
import carom.physics.math.Aabb;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.field.Scope;
import carom.sim.near.Neighbourhood;
import carom.sim.ruling.InterferenceLog;
import carom.sim.ruling.Ruling;
import carom.sim.ruling.RulingLog;
import java.util.function.Predicate;

/**
 * The entities near one player's body, which its client simulates itself: at most {@value
 * NearState#MAX_ENTITIES}.
 *
 * <p>A client that starts from the same state and has the same inputs computes the same bits. So
 * the server sends it four things: the list of entities, a hash of their exact state, the inputs of
 * the other players among them, and exact state where it can't know it. An {@link ExactUpdate}
 * begins
 *
 * <ul>
 *   <li>when an entity enters or leaves the set;
 *   <li>when the game {@linkplain InterferenceLog interferes} with an entity of it, or another
 *       player's input reads what this one isn't told and does something, by more than {@linkplain
 *       RulingDelivery rulings}, which are told by themselves;
 *   <li>when the client reports another hash: then all of it is told.
 * </ul>
 *
 * <p>While an update is being sent, the list stays as it is. What the game {@linkplain
 * carom.sim.Game#audience hides} from the player is never near: neither its state nor its input is
 * told. A client whose body is pushed by it learns that from the exact state of the own body.
 *
 * <p>Belongs to one session. The room's thread; allocates only to grow.
 */
public final class PredictedSet {
  /** Distance beyond a bullet's way within which something may have stopped it, m. */
  private static final float BESIDE_M = 0.1f;

  private final SimulationHost simulation;
  private final int viewer;
  private final InterferenceLog interference;
  private final PredictedSetChooser chooser;
  private final ExactUpdate update;
  private final RulingDelivery rulings;
  private final UpdateLimits limits = new UpdateLimits();
  private final RelayChooser relayChooser;
  private final Neighbourhood state;
  private int capturedTick = -1;

  /** Number of the first ruling that was not there at the last capture. */
  private long nextRuling;

  /** True if the next update must tell all, because the game interfered too long ago. */
  private boolean mustTellAll;

  private boolean hasOutsideCause;
  private boolean wasReached;
  private boolean hasHiddenCause;
  private boolean outside;
  private final Aabb box = new Aabb();
  private final BodyVisitor<HostEntity> outsider = this::isInside;

  /** Changes of the match's fields, which rules read, at the last capture. */
  private long matchChanges;

  private long updates;
  private long disagreements;

  PredictedSet(
      SimulationHost simulation,
      HostPlayer viewer,
      SnapshotEncoder encoder,
      EntityMarks marks,
      Predicate<HostEntity> mayKnow) {
    state = new Neighbourhood(viewer.id());
    this.simulation = simulation;
    this.viewer = viewer.id();
    interference = simulation.interference();
    chooser = new PredictedSetChooser(simulation, marks, mayKnow);
    update = new ExactUpdate(simulation, viewer.id(), encoder);
    rulings = encoder.rulings();
    relayChooser = new RelayChooser(mayKnow);
  }

  /**
   * Captures the set after the simulation's last step.
   *
   * @param player whose body is the centre
   * @param all whether to take as many entities as there is room for, or only what the body may
   *     touch
   * @param disagreedTick newest tick at which the client had another state, or -1
   * @param rowBits what the rows of an update may take in this snapshot: a longer row goes alone,
   *     and if this isn't positive the update waits
   * @param out receives the set; has the own body already
   */
  public void capture(
      HostPlayer player, boolean all, int disagreedTick, int rowBits, OwnState out) {
    if (update.endIfArrived()) {
      limits.arrived();
    }
    if (player.entity() == null) {
      captureNothing(out);
      return;
    }
    long before = updates + disagreements;
    limits.earn(simulation.tick() - capturedTick);
    endUselessUpdate();
    if (update.isSending()) {
      takeRulings();
      if (mayTellInterference()) {
        mustTellAll = true; // the base is of another tick
      }
    } else {
      chooser.choose(player, all, update.members(), limits.entities());
      takeRulings();
      updateIfNeeded(player, disagreedTick);
    }
    readState(updates + disagreements != before);
    relayInputs(player, out);
    capturedTick = simulation.tick();
    writeTo(out, rowBits);
  }

  /** Ends an update that comes too late, or whose list has lost an entity. */
  private void endUselessUpdate() {
    if (update.isTooOld()) {
      if (update.isDue()) {
        limits.timedOut(update.members().count());
      }
      update.cancel();
    }
    if (update.isSending() && !chooser.chooseAgain(update.members())) {
      update.cancel();
    }
  }

  /** Takes over what the rules did to chosen entities since the last capture. */
  private void takeRulings() {
    RulingLog log = interference.rulings();
    mustTellAll |= nextRuling < log.oldest();
    long first = Math.max(nextRuling, log.oldest());
    nextRuling = log.next();
    int bits = 0;
    for (long n = first; n < nextRuling; n++) {
      Ruling r = log.get(n);
      bits += isChosen(r) ? RulingDelivery.bits(r.mask, r.joint) : 0;
    }
    if (bits > RulingDelivery.MOST_BITS) {
      mustTellAll = true; // an update is shorter
      rulings.clear();
      return;
    }
    int tick = simulation.tick();
    for (long n = first; n < nextRuling; n++) {
      Ruling r = log.get(n);
      if (isChosen(r)) {
        noteInput(r);
        mustTellAll |=
            !rulings.add(tick, r.tick, r.moment.ordinal(), r.key, r.joint, r.mask, r.row);
      }
    }
  }

  private void noteInput(Ruling ruling) {
    HostEntity e = simulation.entity(Neighbourhood.id(ruling.key));
    if (ruling.moment == Ruling.Moment.INPUT && e != null) {
      interference.toldInput(e);
    }
  }

  private boolean isChosen(Ruling ruling) {
    HostEntity e = simulation.entity(Neighbourhood.id(ruling.key));
    boolean isOwnInput = ruling.moment == Ruling.Moment.INPUT && e != null && e.ownerId() == viewer;
    return !isOwnInput && chooser.isChosen(Neighbourhood.id(ruling.key));
  }

  private void updateIfNeeded(HostPlayer player, int disagreedTick) {
    boolean disagreed = mayTellDisagreement(disagreedTick);
    boolean interfered = mayTellInterference();
    if (!disagreed && !interfered && update.members().isOf(chooser.chosen())) {
      return;
    }
    boolean isOtherBody =
        !update.isKnown(EntityList.key(player.entity())); // the client begins anew
    update.begin(chooser.chosen(), disagreed || mustTellAll || isOtherBody);
    mustTellAll = false;
    if (disagreed) {
      disagreements++;
    } else {
      updates++;
    }
  }

  /**
   * Takes the right to an update because the client disagrees; false without reason or right. If
   * the update under way explains it, its missing parts are sent again instead.
   */
  private boolean mayTellDisagreement(int disagreedTick) {
    if (!update.isBeyondHelp(disagreedTick)) {
      if (disagreedTick <= update.sentTick()) {
        return false;
      }
      if (update.isHelping()) {
        update.sendMissingAgain();
        return false;
      }
    }
    return !rulings.isBehind() && limits.takeFullUpdate(simulation.tick());
  }

  /**
   * Takes the right to an update because the game interfered with a chosen entity since the last
   * capture; false without reason or right.
   */
  private boolean mayTellInterference() {
    int tick = simulation.tick();
    boolean interfered = mustTellAll;
    for (int i = 0; i < chooser.chosen().count(); i++) {
      HostEntity e = chooser.chosen().get(i);
      int last = interference.lastUntoldTick(e);
      if (last > capturedTick) {
        interfered = true;
        mustTellAll |= interference.wasBeforeStep(e) || last < tick;
      }
    }
    return interfered && limits.takeInterference();
  }

  private void readState(boolean changed) {
    state.clear();
    hasOutsideCause = changed;
    hasHiddenCause = false;
    for (int i = 0; i < chooser.chosen().count(); i++) {
      HostEntity e = chooser.chosen().get(i);
      state.add(e);
      hasOutsideCause |= interference.lastTick(e) > capturedTick;
      hasHiddenCause |= interference.lastHiddenTick(e) > capturedTick && e.ownerId() != viewer;
      interference.watch(e);
    }
    state.read(simulation);
    long ruled = simulation.hasRules() ? simulation.fieldChanges(Scope.MATCH) : 0;
    hasOutsideCause |= ruled != matchChanges; // maybe by what the client doesn't have
    matchChanges = ruled;
    boolean reached = state.cutJoints() > 0 || chooser.isReachedFromOutside();
    hasOutsideCause |= state.leaks() > 0 || reached || wasReached; // maybe until within this tick
    hasOutsideCause |= meetsOutside();
    wasReached = reached;
  }

  /**
   * Returns whether a chosen bullet is so near to a body which isn't among them that this one may
   * have stopped it. A bullet that was stopped has no contact before the next step.
   */
  private boolean meetsOutside() {
    outside = false;
    for (int i = 0; i < chooser.chosen().count() && !outside; i++) {
      Body<HostEntity> body = chooser.chosen().get(i).body();
      if (body.isBullet() && body.awake()) {
        float way = Math.abs(body.velocityX()) + Math.abs(body.velocityY());
        body.aabb(box);
        box.grow(BESIDE_M + way / simulation.tickRate());
        simulation.world().queryAabb(box.minX, box.minY, box.maxX, box.maxY, outsider);
      }
    }
    return outside;
  }

  private boolean isInside(Body<HostEntity> met) {
    outside |= met.type() == BodyType.DYNAMIC && !chooser.isChosen(met.user().id());
    return !outside;
  }

  private void relayInputs(HostPlayer player, OwnState out) {
    out.relayed().clear();
    for (int i = 0; i < chooser.chosen().count(); i++) {
      HostPlayer owner = chooser.chosen().get(i).owner();
      relayChooser.offer(owner, player, capturedTick, simulation.tick(), out);
    }
  }

  private void writeTo(OwnState out, int rowBits) {
    NearState near = out.near();
    KeyList members = update.members();
    near.begin(state.hash());
    for (int i = 0; i < members.count(); i++) {
      near.add(members.get(i));
    }
    int rulingBits = rulings.write(simulation.tick(), rowBits, near);
    update.write(rowBits - rulingBits, out);
    limits.listed(near.listBits(), members.count());
  }

  /**
   * Captures an empty set and forgets what the client knew: in place of {@link #capture} at each
   * tick at which the client asks for nothing. The inputs of others at such a tick aren't told
   * later either.
   *
   * @param out receives it
   */
  public void captureNothing(OwnState out) {
    out.near().clear();
    out.relayed().clear();
    limits.earn(simulation.tick() - capturedTick);
    capturedTick = simulation.tick();
    update.reset();
    rulings.clear();
    nextRuling = interference.rulings().next();
    mustTellAll = false;
  }

  /** Notes that the set captured last is sent. */
  public void sent() {
    update.sent();
  }

  /**
   * Returns the exact state captured last, of which the client is told the hash. For reading only.
   */
  public Neighbourhood state() {
    return state;
  }

  /**
   * Returns whether the state captured last has another cause than the state before and the inputs.
   * Such a cause is that an entity entered or left the set, the game interfered with one, or one
   * was touched by an entity that isn't in the set.
   */
  public boolean hasOutsideCause() {
    return hasOutsideCause;
  }

  /**
   * Returns whether the state captured last follows from an input of another player that read a
   * field of which the client isn't told.
   */
  public boolean hasHiddenCause() {
    return hasHiddenCause;
  }

  /** Returns whether a player's input may look at another body, which a field means. */
  public boolean looksAtOthers(HostPlayer player) {
    return chooser.means(player);
  }

  /** Returns the number of rows of the update that are still to be sent, lost ones included. */
  public int waitingRows() {
    return update.waitingRows();
  }

  /**
   * Returns the number of updates begun because an entity entered or left the set, or the game
   * interfered.
   */
  public long updates() {
    return updates;
  }

  /** Returns the number of updates begun because the client had another state. */
  public long disagreements() {
    return disagreements;
  }
}
