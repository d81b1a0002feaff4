package carom.server.replication;

import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.exact.NearMeter;
import carom.net.snapshot.exact.NearState;
import carom.net.snapshot.exact.OwnState;
import carom.physics.Body;
import carom.physics.BodyContactVisitor;
import carom.physics.BodyVisitor;
import carom.physics.math.Aabb;
import carom.sim.Entity;
import carom.sim.Neighbourhood;
import carom.sim.Player;
import carom.sim.Simulation;
import java.util.Arrays;
import java.util.function.Predicate;

/**
 * Who is near one player's body, for its client to simulate: what it touches, directly or through
 * others, up to {@value NearState#MAX_ENTITIES} bodies; what is close, the closest first, and what
 * that touches, up to {@value #MOST_CLOSE}.
 *
 * <p>A client that simulates these from the same state, with the same inputs, has the same state
 * ever after, so all it must be told is a hash, what the other players among them do, and what the
 * game does to one of them by itself. The exact state is told of whoever comes near, of whom the
 * game {@linkplain Entity#ruledTick moved or pushed}, and of all when the client finds that its
 * hash differs: the state at one tick, spread over as many snapshots as it takes. Meanwhile the
 * list stays as it is. Parts that got lost are sent again until another update begins, which tells
 * them again.
 *
 * <p>Whom the game {@linkplain carom.sim.Game#audience hides} from the player isn't near, and so
 * neither its state nor its input is told; a client that is pushed by it learns that from the exact
 * state of the own body.
 *
 * <p>One session's; the room's thread; allocates only to grow.
 */
public final class NearSet {
  /** Who is within this distance is near, and leaves at {@link #LEAVE} times it, metres. */
  private static final float NEAR_METRES = 3;

  private static final float ALL_METRES = 15;
  private static final float LEAVE = 1.4f;

  /** What comes closer is near as early as this before it arrives, seconds. */
  private static final float LEAD_SECONDS = 0.3f;

  /** What the body doesn't touch is listed while the list is shorter than this. */
  private static final int MOST_CLOSE = 63;

  /** Exact state told per snapshot, and the list, bits: together less than a datagram. */
  private static final int PART_BITS = 5_500;

  private static final int MAX_LIST_BITS = 3_000;

  /** How much longer the list may become after each update that arrived. */
  private static final int REGAINED = 8;

  /** Slow lines and small budgets: lists get no shorter than this. */
  private static final int FEWEST = 4;

  /** Shortest and longest time from one disagreement to telling everything again, ticks. */
  private static final int MIN_GAP = 4;

  private static final int MAX_GAP = 120;

  /** Updates for what the game did begin at most so often: one in so many ticks in the long run. */
  private static final int RULING_TICKS = 5;

  /** So many may begin at once, after a quiet time. */
  private static final int MOST_RULINGS = 6;

  /** An update whose parts take longer is given up: its base would leave the client's memory. */
  private static final int MAX_AGE = 60;

  /**
   * Updates of so few parts are sent twice where parts get lost: waiting for one costs a round
   * trip.
   */
  private static final int TWICE_PARTS = 2;

  /** So long after a loss the line counts as one that loses. */
  private static final int LOSSY_TICKS = 600;

  /** A snapshot is lost when one so many ticks younger has arrived. */
  private static final int OVERTAKEN_TICKS = 3;

  private static final int NEVER = -1_000;

  /** Parts on their way. */
  private static final int PARTS = 64;

  /**
   * Marks on entities, by id. One for all sessions of a room: they choose one after the other.
   * Allocates only to grow.
   */
  static final class Marks {
    private int[] listed = new int[64];
    private int[] member = new int[64];
    private int round;

    /** Removes all marks. */
    void clear(int capacity) {
      round++;
      if (listed.length < capacity) {
        listed = Arrays.copyOf(listed, Math.max(2 * listed.length, capacity));
        member = Arrays.copyOf(member, listed.length);
      }
    }

    /** Marks as listed; false when it was already. */
    boolean list(int id) {
      boolean fresh = listed[id] != round;
      listed[id] = round;
      return fresh;
    }

    void member(int id) {
      if (id < member.length) {
        member[id] = round;
      }
    }

    boolean isMember(int id) {
      return member[id] == round;
    }
  }

  private final Simulation simulation;
  private final Marks marks;
  private final Predicate<Entity> mayKnow;
  private final Neighbourhood state = new Neighbourhood();
  private final NearMeter meter = new NearMeter();
  private final Aabb box = new Aabb();
  private final BodyVisitor<Entity> closeBy = this::consider;
  private final BodyContactVisitor<Entity> touching =
      (other, normalX, normalY, impulse) -> reach(other.user());

  /** Who is near: keys, in the order of the world; those of the last update. */
  private int[] memberKey = new int[16];

  private int members;

  /** Whom the client was told, or could compute: keys. */
  private int[] knownKey = new int[16];

  private int known;

  /** Most whose list is short enough. */
  private int mostListed = NearState.MAX_ENTITIES;

  /** Most that are near: fewer for a while when an update didn't get through. */
  private int most = NearState.MAX_ENTITIES;

  // The update under way, or the last one.
  private final Neighbourhood base = new Neighbourhood();
  private boolean updating;
  private int baseTick;
  private int[] told = new int[16];
  private int toldCount;
  private boolean[] isTold = new boolean[16];

  /** Who came near just now, awake, and whom it touches, directly or through others. */
  private boolean[] strikes = new boolean[16];

  private int[] toldContact = new int[16];
  private int toldContacts;
  private boolean[] due = new boolean[16];
  private int dueRows;

  /** Told by updates before this one that may not have arrived: keys. */
  private int[] unsureKey = new int[16];

  private int unsure;

  /** Whether the next update tells all. */
  private boolean tellsAll;

  /** Whether even an update without rows is to be sent: that others went is all it tells. */
  private boolean announced;

  /** When a datagram was last known to be lost. */
  private int lossTick = -LOSSY_TICKS;

  /** Whether all of it has been sent, though perhaps not all has arrived. */
  private boolean sentOnce;

  /** Whether an update was followed by another before all of it had arrived, and none told all. */
  private boolean torn;

  /** Whether what was captured last has a part of the update, and which rows. */
  private boolean hasPart;

  private int firstRow;
  private int partRows;

  /** Ticks' worth of updates that may begin for what the game did. */
  private int rulingCredit = RULING_TICKS * MOST_RULINGS;

  private int capturedTick = -1;

  /** By player: the last tick at which its inputs were relayed. */
  private int[] relayedTick = {};

  private boolean surprising;

  /** Tick at which the last row went out that had to; what differs later differs all the same. */
  private int toldTick = -1;

  private int toldAllTick = -1;
  private long updates;
  private long disagreements;
  private int gap = MIN_GAP;

  // What went out, by part.
  private final int[] sentTick = new int[PARTS];
  private final int[] sentFirst = new int[PARTS];
  private final int[] sentRows = new int[PARTS];
  private int sentParts;

  private Entity[] listed = new Entity[16];
  private long[] order = new long[16];
  private int count;
  private int limit;
  private Entity[] candidates = new Entity[16];
  private float[] distance = new float[16];
  private int candidateCount;
  private Body<Entity> own;
  private float reachMetres;

  NearSet(Simulation simulation, Marks marks, Predicate<Entity> mayKnow) {
    this.simulation = simulation;
    this.marks = marks;
    this.mayKnow = mayKnow;
  }

  /**
   * Lists who is near.
   *
   * @param player whose body is the centre
   * @param all whether to take as many as there is room for, or only whom the body may touch
   * @param disagreedTick newest tick at which the client had another state, or -1
   * @param rowBits what the rows of an update may take in this snapshot: a row that is longer goes
   *     alone; none while this isn't positive, then the update waits
   * @param out receives it; has the own body already
   */
  public void capture(Player player, boolean all, int disagreedTick, int rowBits, OwnState out) {
    if (player.body() == null) {
      captureNothing(out);
      return;
    }
    NearState near = out.near();
    out.relayed().clear();
    long begun = updates + disagreements;
    int before = capturedTick;
    if (updating && simulation.tick() - baseTick > MAX_AGE) {
      giveUp();
    }
    if (isDue() && !sentOnce && !listMembers()) {
      updating = false;
    }
    if (!isDue() || sentOnce) {
      choose(player, all);
      boolean again = mustTellAll(disagreedTick);
      boolean ruled = isRuled();
      if (again || ruled || !isSameList()) {
        beginUpdate(again || tellsAll);
        updates += again ? 0 : 1;
        disagreements += again ? 1 : 0;
        tellsAll = false;
      }
    } else if (isRuled()) {
      tellsAll = true; // the base is of another tick
    }
    capturedTick = simulation.tick();
    state.clear();
    int relayed = 0;
    surprising = updates + disagreements != begun;
    for (int i = 0; i < count; i++) {
      state.add(listed[i]);
      surprising |= listed[i].ruledTick() > before;
      simulation.watch(listed[i]);
      Player owner = simulation.owner(listed[i]);
      if (owner != null
          && relayed < OwnState.MAX_RELAYED
          && isTellable(owner, player)
          && isNoReturn(owner, before)) {
        out.relayed().add(owner.id());
        relayed++;
      }
    }
    state.read(simulation);
    surprising |= state.leaks() > 0;
    near.begin(state.hash());
    for (int i = 0; i < members; i++) {
      near.add(memberKey[i]);
    }
    partRows = 0;
    hasPart = isDue() && (dueRows == 0 || rowBits > 0);
    if (hasPart) {
      writePart(out, rowBits);
    }
    limitList(near.listBits());
  }

  /**
   * Lists nobody, and forgets whom the client knew: in place of {@link #capture} at each tick at
   * which the client asks for nothing. What others do at such a tick isn't told later either.
   *
   * @param out receives it
   */
  public void captureNothing(OwnState out) {
    out.near().clear();
    out.relayed().clear();
    earnRulingCredit();
    capturedTick = simulation.tick();
    hasPart = false;
    members = 0;
    known = 0;
    updating = false;
    torn = false;
    tellsAll = false;
  }

  /** Whether what another player does is told: not when its body is hidden. */
  private boolean isTellable(Player other, Player to) {
    return other != to && (other.body() == null || mayKnow.test(other.body()));
  }

  /**
   * Whether a player was relayed the last time, too, or not for long. In between, what it does
   * isn't this client's business, yet would be told from the baseline on if it were relayed again.
   */
  private boolean isNoReturn(Player other, int before) {
    if (relayedTick.length <= other.id()) {
      int size = relayedTick.length;
      relayedTick = Arrays.copyOf(relayedTick, Math.max(2 * size, other.id() + 1));
      Arrays.fill(relayedTick, size, relayedTick.length, NEVER);
    }
    int last = relayedTick[other.id()];
    if (last != before && capturedTick - last <= OwnState.RELAYED_TICKS) {
      return false;
    }
    relayedTick[other.id()] = capturedTick;
    return true;
  }

  /** Whether the next snapshot has a part of an update. */
  private boolean isDue() {
    return updating && (dueRows > 0 || !announced);
  }

  /**
   * Whether the client must be told what the game did to one of those listed since the last time.
   * In a game that pushes all the time that would be too much: then the client finds out.
   */
  private boolean isRuled() {
    int tick = simulation.tick();
    earnRulingCredit();
    boolean ruled = tellsAll;
    for (int i = 0; i < count; i++) {
      Entity e = listed[i];
      if (e.ruledTick() > capturedTick) {
        ruled = true;
        tellsAll |= e.ruledEarly() || e.ruledTick() < tick;
      }
    }
    if (!ruled || rulingCredit < RULING_TICKS) {
      return false;
    }
    rulingCredit -= RULING_TICKS;
    return true;
  }

  /** For the ticks since the last capture. */
  private void earnRulingCredit() {
    int ticks = simulation.tick() - capturedTick;
    rulingCredit = Math.min(RULING_TICKS * MOST_RULINGS, rulingCredit + ticks);
  }

  /** A client whose line is too slow for the update is told of fewer. */
  private void giveUp() {
    boolean slow = isDue();
    updating = false;
    if (slow) {
      most = Math.max(FEWEST, members / 2);
    }
  }

  /** Lists that take too much to tell are shorter from the next time on. */
  private void limitList(int bits) {
    if (bits > MAX_LIST_BITS) {
      mostListed = Math.max(FEWEST, members * 3 / 4);
      most = Math.min(most, mostListed);
    }
  }

  /** Lists the members again; false when one of them is gone, or hidden from now on. */
  private boolean listMembers() {
    count = 0;
    for (int i = 0; i < members; i++) {
      Entity e = simulation.entity(Neighbourhood.id(memberKey[i]));
      if (e == null || key(e) != memberKey[i] || !mayKnow.test(e)) {
        return false;
      }
      list(e);
    }
    return true;
  }

  private void choose(Player player, boolean all) {
    own = player.body().body();
    reachMetres = all ? ALL_METRES : NEAR_METRES;
    marks.clear(simulation.entityCapacity());
    for (int i = 0; i < members; i++) {
      Entity e = simulation.entity(Neighbourhood.id(memberKey[i]));
      if (e != null && key(e) == memberKey[i]) {
        marks.member(e.id());
      }
    }
    count = 0;
    limit = most;
    spread(player.body());
    limit = Math.min(most, Math.max(count, MOST_CLOSE));
    gather();
    for (int i = 0; i < candidateCount; i++) {
      spread(candidates[i]);
    }
    Arrays.fill(candidates, 0, candidateCount, null);
    sort();
  }

  /** By the order of their bodies in the world. */
  private void sort() {
    if (order.length < count) {
      order = new long[listed.length];
    }
    for (int i = 0; i < count; i++) {
      order[i] = (long) listed[i].body().index() << Integer.SIZE | listed[i].id();
    }
    Arrays.sort(order, 0, count);
    for (int i = 0; i < count; i++) {
      listed[i] = simulation.entity((int) order[i]);
    }
  }

  private boolean isSameList() {
    if (count != members) {
      return false;
    }
    for (int i = 0; i < count; i++) {
      if (key(listed[i]) != memberKey[i]) {
        return false;
      }
    }
    return true;
  }

  /** Whoever disagrees again and again is told less and less often: it can't be helped. */
  private boolean mustTellAll(int disagreedTick) {
    int tick = simulation.tick();
    if (toldAllTick >= 0 && tick - toldAllTick > 2 * MAX_GAP) {
      gap = MIN_GAP;
    }
    boolean old = disagreedTick <= toldTick;
    if (old || (updating && !torn) || (toldAllTick >= 0 && tick - toldAllTick < gap)) {
      return false;
    }
    gap = Math.min(MAX_GAP, 2 * gap);
    toldAllTick = tick;
    return true;
  }

  private void beginUpdate(boolean all) {
    torn = !all && (torn || (updating && sentParts > 0));
    noteUnsure();
    updating = true;
    sentOnce = false;
    announced = false;
    baseTick = simulation.tick();
    sentParts = 0;
    members = count;
    ensure();
    base.clear();
    for (int i = 0; i < count; i++) {
      memberKey[i] = key(listed[i]);
      base.add(listed[i]);
    }
    base.read(simulation);
    toldCount = 0;
    for (int i = 0, from = 0; i < count; i++) {
      int at = findKnown(memberKey[i], from);
      from = at < 0 ? from : at + 1;
      isTold[i] = all || at < 0 || listed[i].ruledTick() == baseTick || isUnsure(memberKey[i]);
      strikes[i] = at < 0 && listed[i].body().awake();
    }
    tellStruck();
    for (int i = 0; i < count; i++) {
      if (isTold[i]) {
        told[toldCount++] = i;
      }
    }
    toldContacts = 0;
    for (int i = 0; i < base.contactCount(); i++) {
      int at = i * Neighbourhood.CONTACT_INTS;
      boolean one = isTold(base.contacts()[at]) || isTold(base.contacts()[at + 1]);
      if (one && toldCount + toldContacts < NearState.MAX_ROWS) {
        if (toldContacts == toldContact.length) {
          toldContact = Arrays.copyOf(toldContact, 2 * toldContacts);
        }
        toldContact[toldContacts++] = at;
      }
    }
    dueRows = toldCount + toldContacts;
    if (due.length < dueRows) {
      due = new boolean[Math.max(2 * due.length, dueRows)];
    }
    Arrays.fill(due, 0, dueRows, true);
  }

  /**
   * Who comes near by touching somebody has moved all that hang together with it in this very tick,
   * and the client, who didn't know of it, has them where they would be without.
   */
  private void tellStruck() {
    boolean grew = true;
    while (grew) {
      grew = false;
      for (int i = 0; i < base.contactCount(); i++) {
        int one = base.contacts()[i * Neighbourhood.CONTACT_INTS];
        int other = base.contacts()[i * Neighbourhood.CONTACT_INTS + 1];
        if (one >= 0 && other >= 0 && strikes[one] != strikes[other]) {
          strikes[one] = strikes[other] = true;
          isTold[one] = isTold[other] = true;
          grew = true;
        }
      }
    }
  }

  /** Where datagrams get lost, what was told lately may not have arrived: it is told again. */
  private void noteUnsure() {
    unsure = 0;
    if (!updating || !isLossy()) {
      return;
    }
    if (unsureKey.length < toldCount) {
      unsureKey = new int[told.length];
    }
    for (int i = 0; i < toldCount; i++) {
      unsureKey[unsure++] = memberKey[told[i]];
    }
  }

  private boolean isUnsure(int key) {
    for (int i = 0; i < unsure; i++) {
      if (unsureKey[i] == key) {
        return true;
      }
    }
    return false;
  }

  private boolean isLossy() {
    return simulation.tick() - lossTick < LOSSY_TICKS;
  }

  private void ensure() {
    if (memberKey.length < count) {
      int room = Math.max(2 * memberKey.length, count);
      memberKey = new int[room];
      told = new int[room];
      isTold = new boolean[room];
      strikes = new boolean[room];
    }
  }

  private boolean isTold(int end) {
    return end >= 0 && isTold[end];
  }

  /** Both lists follow the order of the world. */
  private int findKnown(int key, int likely) {
    for (int i = 0, at = likely; i < known; i++, at++) {
      at = at < known ? at : 0;
      if (knownKey[at] == key) {
        return at;
      }
    }
    return -1;
  }

  private void writePart(OwnState out, int rowBits) {
    NearState near = out.near();
    int total = toldCount + toldContacts;
    firstRow = 0;
    while (firstRow < total && !due[firstRow]) {
      firstRow++;
    }
    near.beginPart(simulation.tick() - baseTick, total, firstRow);
    for (int i = 0; i < toldCount; i++) {
      near.tell(told[i]);
    }
    int room = Math.min(rowBits, PART_BITS - near.listBits());
    meter.begin(out);
    for (int row = firstRow; row < total && due[row] && partRows < NearState.MAX_PART; row++) {
      boolean isEntity = row < toldCount;
      int[] from = isEntity ? base.entities() : base.contacts();
      int at = isEntity ? told[row] * Neighbourhood.ENTITY_INTS : toldContact[row - toldCount];
      meter.add(isEntity, from, at);
      if (meter.bits() > room && partRows > 0) {
        break;
      }
      near.addRow(from, at);
      partRows++;
    }
  }

  /** The exact state captured last, of which the client is told the hash. Look, don't touch. */
  public Neighbourhood state() {
    return state;
  }

  /**
   * Whether the state captured last follows from more than the one before and the inputs: somebody
   * came or went, the game moved or pushed one, or one was touched by somebody who isn't listed.
   */
  public boolean surprising() {
    return surprising;
  }

  /** Rows of the update under way that are still to be sent, those that got lost included. */
  public int waitingRows() {
    return updating ? dueRows : 0;
  }

  /** Updates begun because the list of who is near changed. */
  public long updates() {
    return updates;
  }

  /** Updates begun because the client had another state. */
  public long disagreements() {
    return disagreements;
  }

  /** Notes that what was captured last is sent. */
  public void sent() {
    if (!hasPart) {
      return;
    }
    hasPart = false;
    announced = true;
    Arrays.fill(due, firstRow, firstRow + partRows, false);
    dueRows -= partRows;
    if (sentParts < PARTS) {
      sentTick[sentParts] = simulation.tick();
      sentFirst[sentParts] = firstRow;
      sentRows[sentParts] = partRows;
      sentParts++;
    }
    if (dueRows == 0) {
      if (isLossy() && !sentOnce && sentParts <= TWICE_PARTS) {
        dueRows = toldCount + toldContacts;
        Arrays.fill(due, 0, dueRows, true);
        announced = false;
      }
      sentOnce = true;
      toldTick = simulation.tick();
      if (knownKey.length < members) {
        knownKey = new int[memberKey.length];
      }
      known = members;
      System.arraycopy(memberKey, 0, knownKey, 0, members);
    }
  }

  /** Looks which parts have arrived, and which are lost and must be sent again. */
  public void acknowledge(SnapshotEncoder encoder) {
    if (encoder.hasLost()) {
      lossTick = simulation.tick();
    }
    if (!updating) {
      return;
    }
    int open = 0;
    for (int i = 0; i < sentParts; i++) {
      if (encoder.hasAckedOwn(sentTick[i])) {
        continue;
      }
      if (encoder.ownAckedTick() - sentTick[i] >= OVERTAKEN_TICKS) {
        Arrays.fill(due, sentFirst[i], sentFirst[i] + sentRows[i], true);
        dueRows += sentRows[i];
        announced &= sentRows[i] > 0;
        continue;
      }
      sentTick[open] = sentTick[i];
      sentFirst[open] = sentFirst[i];
      sentRows[open] = sentRows[i];
      open++;
    }
    sentParts = open;
    if (open == 0 && !isDue()) {
      updating = false;
      most = Math.min(mostListed, most + REGAINED);
    }
  }

  private static int key(Entity e) {
    return Neighbourhood.key(e.id(), e.generation());
  }

  /** Lists an entity, and all that it touches directly or not, as far as there is room. */
  private void spread(Entity from) {
    int next = count;
    reach(from);
    for (; next < count; next++) {
      listed[next].body().forEachContact(touching);
    }
  }

  private void reach(Entity e) {
    boolean solid = !e.isLevel() && Neighbourhood.isSolid(e.archetype());
    if (solid && count < limit && marks.list(e.id()) && mayKnow.test(e)) {
      list(e);
    }
  }

  private void list(Entity e) {
    if (count == listed.length) {
      listed = Arrays.copyOf(listed, 2 * count);
    }
    listed[count++] = e;
  }

  private void gather() {
    candidateCount = 0;
    own.aabb(box);
    float speed = length(own.velocityX(), own.velocityY());
    float range = reachMetres * LEAVE + 2 * speed * LEAD_SECONDS;
    simulation
        .world()
        .queryAabb(box.minX - range, box.minY - range, box.maxX + range, box.maxY + range, closeBy);
  }

  private boolean consider(Body<Entity> body) {
    Entity e = body.user();
    boolean solid = !e.isLevel() && Neighbourhood.isSolid(e.archetype());
    if (!solid || body == own || !mayKnow.test(e)) {
      return true;
    }
    body.aabb(box);
    float dx = Math.max(0, Math.max(box.minX - own.x(), own.x() - box.maxX));
    float dy = Math.max(0, Math.max(box.minY - own.y(), own.y() - box.maxY));
    float away = length(dx, dy);
    float closing =
        away == 0
            ? 0
            : ((own.velocityX() - body.velocityX()) * (body.x() - own.x())
                    + (own.velocityY() - body.velocityY()) * (body.y() - own.y()))
                / Math.max(1e-3f, length(body.x() - own.x(), body.y() - own.y()));
    float soon = away - Math.max(0, closing) * LEAD_SECONDS;
    boolean member = marks.isMember(e.id());
    if (soon <= reachMetres * (member ? LEAVE : 1)) {
      insert(e, member ? soon / LEAVE : soon);
    }
    return true;
  }

  /** Keeps candidates sorted by distance. */
  private void insert(Entity e, float soon) {
    if (candidateCount == candidates.length) {
      if (candidateCount >= 4 * MOST_CLOSE) {
        return; // a crowd: the query's order decides
      }
      candidates = Arrays.copyOf(candidates, 2 * candidateCount);
      distance = Arrays.copyOf(distance, 2 * candidateCount);
    }
    int at = candidateCount++;
    for (; at > 0 && distance[at - 1] > soon; at--) {
      candidates[at] = candidates[at - 1];
      distance[at] = distance[at - 1];
    }
    candidates[at] = e;
    distance[at] = soon;
  }

  private static float length(float x, float y) {
    return (float) Math.sqrt(x * x + y * y);
  }
}
