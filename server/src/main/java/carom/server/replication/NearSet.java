package carom.server.replication;

import carom.net.snapshot.NearState;
import carom.net.snapshot.OwnState;
import carom.physics.Body;
import carom.physics.BodyContactVisitor;
import carom.physics.BodyVisitor;
import carom.physics.math.Aabb;
import carom.sim.Entity;
import carom.sim.Neighbourhood;
import carom.sim.Player;
import carom.sim.Simulation;
import java.util.Arrays;

/**
 * Who is near one player's body, for its client to simulate: what it touches, directly or through
 * others; what is close, the closest first; and what those touch.
 *
 * <p>A client that simulates these from the same state, with the same inputs, has the same state
 * ever after, so all it must be told is a hash, and what the other players among them do. The exact
 * state is told of whoever comes near, and of all when the client finds that its hash differs: the
 * state at one tick, spread over as many snapshots as it takes. Meanwhile the list stays as it is.
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

  /** Exact state told per snapshot, bits. */
  private static final int PART_BITS = 4_500;

  /** Shortest and longest time from one disagreement to telling everything again, ticks. */
  private static final int MIN_GAP = 4;

  private static final int MAX_GAP = 120;

  /** An update whose parts take longer is given up: its base would leave the client's memory. */
  private static final int MAX_AGE = 60;

  private final Simulation simulation;
  private final Neighbourhood state = new Neighbourhood();
  private final Aabb box = new Aabb();
  private final BodyVisitor<Entity> closeBy = this::consider;
  private final BodyContactVisitor<Entity> touching =
      (other, normalX, normalY, impulse) -> reach(other.user());

  /** Who is near: keys, in the order of the world; the first of them are of the last update. */
  private int[] memberKey = new int[NearState.MAX_ENTITIES];

  private int members;

  /** Whom the client was told, or could compute: keys. */
  private final int[] knownKey = new int[NearState.MAX_ENTITIES];

  private int known;

  // The update under way.
  private final Neighbourhood base = new Neighbourhood();
  private boolean updating;
  private int baseTick;
  private long told;
  private final int[] toldContact = new int[NearState.MAX_ROWS];
  private int toldContacts;
  private int nextRow;
  private int partRows;
  private int toldAllTick = -1;
  private int gap = MIN_GAP;

  private Entity[] listed = new Entity[16];
  private int count;
  private Entity[] candidates = new Entity[16];
  private float[] distance = new float[16];
  private int candidateCount;
  private Body<Entity> own;
  private float reachMetres;

  NearSet(Simulation simulation) {
    this.simulation = simulation;
  }

  /**
   * Lists who is near.
   *
   * @param player whose body is the centre
   * @param all whether to take as many as there is room for, or only whom the body may touch
   * @param disagreedTick newest tick at which the client had another state, or -1
   * @param out receives it
   */
  public void capture(Player player, boolean all, int disagreedTick, OwnState out) {
    NearState near = out.near();
    out.relayed().clear();
    if (player.body() == null) {
      forget();
      near.clear();
      return;
    }
    if (updating && (simulation.tick() - baseTick > MAX_AGE || !listMembers())) {
      updating = false;
    }
    if (!updating) {
      choose(player, all);
      boolean again = mustTellAll(disagreedTick);
      if (again || !isSameList()) {
        beginUpdate(again);
      }
    }
    state.clear();
    int relayed = 0;
    for (int i = 0; i < count; i++) {
      state.add(listed[i]);
      int owner = listed[i].ownerId();
      if (owner != Entity.NO_OWNER && owner != player.id() && relayed < OwnState.MAX_RELAYED) {
        out.relayed().add(owner);
        relayed++;
      }
    }
    state.read(simulation);
    near.begin(state.hash());
    for (int i = 0; i < members; i++) {
      near.add(memberKey[i]);
    }
    if (updating) {
      writePart(near);
    }
  }

  private void forget() {
    members = 0;
    known = 0;
    updating = false;
  }

  /** Lists the members again; false when one of them is gone. */
  private boolean listMembers() {
    count = 0;
    for (int i = 0; i < members; i++) {
      Entity e = simulation.entity(Neighbourhood.id(memberKey[i]));
      if (e == null || key(e) != memberKey[i]) {
        return false;
      }
      list(e);
    }
    return true;
  }

  private void choose(Player player, boolean all) {
    own = player.body().body();
    reachMetres = all ? ALL_METRES : NEAR_METRES;
    count = 0;
    spread(player.body());
    gather();
    for (int i = 0; i < candidateCount; i++) {
      spread(candidates[i]);
    }
    Arrays.fill(candidates, 0, candidateCount, null);
    sort();
  }

  /** By the order of their bodies in the world. */
  private void sort() {
    for (int i = 1; i < count; i++) {
      Entity e = listed[i];
      int j = i;
      for (; j > 0 && listed[j - 1].body().index() > e.body().index(); j--) {
        listed[j] = listed[j - 1];
      }
      listed[j] = e;
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
    if (disagreedTick <= baseTick || (toldAllTick >= 0 && tick - toldAllTick < gap)) {
      return false;
    }
    gap = Math.min(MAX_GAP, 2 * gap);
    toldAllTick = tick;
    return true;
  }

  private void beginUpdate(boolean all) {
    updating = true;
    baseTick = simulation.tick();
    nextRow = 0;
    members = count;
    base.clear();
    for (int i = 0; i < count; i++) {
      memberKey[i] = key(listed[i]);
      base.add(listed[i]);
    }
    base.read(simulation);
    told = 0;
    for (int i = 0; i < count; i++) {
      if (all || !isKnown(memberKey[i])) {
        told |= 1L << i;
      }
    }
    toldContacts = 0;
    for (int i = 0; i < base.contactCount(); i++) {
      int at = i * Neighbourhood.CONTACT_INTS;
      boolean one = isTold(base.contacts()[at]) || isTold(base.contacts()[at + 1]);
      if (one && toldContacts < NearState.MAX_ROWS - NearState.MAX_ENTITIES) {
        toldContact[toldContacts++] = at;
      }
    }
  }

  private boolean isTold(int end) {
    return end >= 0 && (told >>> end & 1) != 0;
  }

  private boolean isKnown(int key) {
    for (int i = 0; i < known; i++) {
      if (knownKey[i] == key) {
        return true;
      }
    }
    return false;
  }

  private void writePart(NearState near) {
    int entities = Long.bitCount(told);
    int total = entities + toldContacts;
    near.beginPart(simulation.tick() - baseTick, told, total, nextRow);
    int bits = 0;
    partRows = 0;
    while (nextRow + partRows < total && partRows < NearState.MAX_PART) {
      int row = nextRow + partRows;
      boolean isEntity = row < entities;
      int[] from = isEntity ? base.entities() : base.contacts();
      int at = isEntity ? toldEntity(row) * Neighbourhood.ENTITY_INTS : toldContact[row - entities];
      int ints = isEntity ? Neighbourhood.ENTITY_INTS : Neighbourhood.CONTACT_INTS;
      bits += NearState.bits(from, at, ints);
      if (bits > PART_BITS && partRows > 0) {
        break;
      }
      near.addRow(from, at);
      partRows++;
    }
  }

  /** The place in the list of the n-th told entity. */
  private int toldEntity(int n) {
    long rest = told;
    for (int i = 0; i < n; i++) {
      rest &= rest - 1;
    }
    return Long.numberOfTrailingZeros(rest);
  }

  /** Notes that what was captured last is sent. */
  public void sent() {
    if (!updating) {
      return;
    }
    nextRow += partRows;
    if (nextRow >= Long.bitCount(told) + toldContacts) {
      updating = false;
      known = members;
      System.arraycopy(memberKey, 0, knownKey, 0, members);
    }
  }

  private boolean isMember(Entity e) {
    int key = key(e);
    for (int i = 0; i < members; i++) {
      if (memberKey[i] == key) {
        return true;
      }
    }
    return false;
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
    if (solid && count < NearState.MAX_ENTITIES && !isListed(e)) {
      list(e);
    }
  }

  private void list(Entity e) {
    if (count == listed.length) {
      listed = Arrays.copyOf(listed, 2 * count);
    }
    listed[count++] = e;
  }

  private boolean isListed(Entity e) {
    for (int i = 0; i < count; i++) {
      if (listed[i] == e) {
        return true;
      }
    }
    return false;
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
    if (e.isLevel() || body == own || !Neighbourhood.isSolid(e.archetype())) {
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
    boolean member = isMember(e);
    if (soon <= reachMetres * (member ? LEAVE : 1)) {
      insert(e, member ? soon / LEAVE : soon);
    }
    return true;
  }

  /** Keeps candidates sorted by distance. */
  private void insert(Entity e, float soon) {
    if (candidateCount == candidates.length) {
      if (candidateCount == 4 * NearState.MAX_ENTITIES) {
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
