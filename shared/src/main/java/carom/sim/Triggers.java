package carom.sim;

import carom.physics.Body;
import carom.physics.BodyVisitor;
import carom.physics.Collision;
import carom.sim.entity.EntityTable;
import carom.sim.entity.HostEntity;
import java.util.Arrays;
import java.util.List;

/**
 * The visits of entities to sensors. It turns the begin and the end of contacts, of which a
 * compound has several, into one visit each, and tells them when rules may run.
 *
 * <pre>
 *   rules, inputs  settle  physics: begin, end  tell  afterStep  tell
 *   end of what goes ──►│──► left                │     end of what goes ──►│
 * </pre>
 *
 * <p>A visit lasts while any shape of the visitor is in any shape of the sensor. It ends, too, when
 * one of both is despawned or becomes another archetype, and that is told once.
 *
 * <p>What is known here follows from the contacts of the world, so it is no state of its own:
 * {@link #restore} reads it anew. Between two ticks nothing waits to be told. One thread; allocates
 * only to grow.
 */
final class Triggers {
  /** Is told of visits. It may spawn and despawn. */
  public interface Listener {
    /** Receives that an entity entered a sensor. Both exist. */
    void entered(HostEntity sensor, HostEntity visitor);

    /** Receives that an entity left a sensor. Either may be despawned. */
    void left(HostEntity sensor, HostEntity visitor);
  }

  private static final byte ENTERED = 0;
  private static final byte LEFT = 1;

  /** A contact of a visit ended; maybe another goes on. */
  private static final byte CONTACT_ENDED = 2;

  private static final byte NOTHING = 3;

  private final EntityTable entities;
  private final List<HostEntity> statics;
  private final Listener listener;

  // The visits that last: two body slots, by which they are sorted; sensor and visitor.
  private int count;
  private long[] keys = new long[16];
  private HostEntity[] pairs = new HostEntity[32];

  // What happened and isn't told yet: what; key; sensor and visitor.
  private int waiting;
  private byte[] kinds = new byte[16];
  private long[] waitingKeys = new long[16];
  private HostEntity[] waitingPairs = new HostEntity[32];

  private boolean telling;

  // Scratch of questions about overlaps.
  private Body<HostEntity> sought;
  private HostEntity host;
  private boolean found;
  private final BodyVisitor<HostEntity> seek = this::seek;
  private final BodyVisitor<HostEntity> collect = this::collect;

  /**
   * Creates the visits of a simulation that has none yet.
   *
   * @param entities the simulation's
   * @param statics the static geometry of the level, which may still grow
   * @param listener is told of them
   */
  public Triggers(EntityTable entities, List<HostEntity> statics, Listener listener) {
    this.entities = entities;
    this.statics = statics;
    this.listener = listener;
  }

  /** Notes a contact that begins, if it is one of a sensor. */
  public void begin(Collision<HostEntity> c) {
    if (!c.isSensor()) {
      return;
    }
    HostEntity self = c.self().user();
    HostEntity other = c.other().user();
    HostEntity sensor = self.archetype().sensor() ? self : other;
    HostEntity visitor = sensor == self ? other : self;
    if (sensor.archetype().sensor() && add(sensor, visitor)) {
      queue(ENTERED, key(sensor, visitor), sensor, visitor);
    }
  }

  /** Notes a contact that ends, if it is one of a sensor. */
  public void end(Collision<HostEntity> c) {
    if (!c.isSensor()) {
      return;
    }
    long key = key(c.self().user(), c.other().user());
    int at = find(key);
    if (at >= 0) {
      queue(CONTACT_ENDED, key, pairs[2 * at], pairs[2 * at + 1]);
    }
  }

  /** Decides which visits have ended by now, before contacts begin anew. */
  public void settle() {
    for (int i = 0; i < waiting; i++) {
      settle(i);
    }
  }

  private void settle(int i) {
    if (kinds[i] != CONTACT_ENDED) {
      return;
    }
    HostEntity sensor = waitingPairs[2 * i];
    HostEntity visitor = waitingPairs[2 * i + 1];
    kinds[i] = NOTHING;
    int at = find(waitingKeys[i]);
    if (at >= 0 && pairs[2 * at] == sensor && !overlap(sensor, visitor)) {
      remove(at);
      kinds[i] = LEFT;
    }
  }

  /**
   * Tells what happened, in the order in which it did, and what these calls bring about. Nothing
   * happens if it is telling already.
   */
  public void tell() {
    if (telling) {
      return;
    }
    telling = true;
    try {
      for (int i = 0; i < waiting; i++) {
        settle(i);
        tell(kinds[i], waitingKeys[i], waitingPairs[2 * i], waitingPairs[2 * i + 1]);
      }
    } finally {
      telling = false;
      Arrays.fill(waitingPairs, 0, 2 * waiting, null);
      waiting = 0;
    }
  }

  private void tell(byte kind, long key, HostEntity sensor, HostEntity visitor) {
    if (kind == LEFT) {
      listener.left(sensor, visitor);
    } else if (kind == ENTERED && sensor.body().isValid() && visitor.body().isValid()) {
      listener.entered(sensor, visitor);
    } else if (kind == ENTERED) { // one before it despawned one of both
      int at = find(key);
      if (at >= 0 && pairs[2 * at] == sensor) {
        remove(at);
      }
    }
  }

  /** Reads the visits of a state that was restored. */
  public void restore() {
    Arrays.fill(pairs, 0, 2 * count, null);
    count = 0;
    Arrays.fill(waitingPairs, 0, 2 * waiting, null);
    waiting = 0;
    for (int id = 0; id < entities.capacity(); id++) {
      read(entities.get(id));
    }
    for (int i = 0; i < statics.size(); i++) {
      read(statics.get(i));
    }
    host = null;
  }

  private void read(HostEntity entity) {
    if (entity != null && entity.archetype().sensor()) {
      host = entity;
      entity.body().forEachOverlap(collect);
    }
  }

  private boolean collect(Body<HostEntity> other) {
    add(host, other.user());
    return true;
  }

  private boolean overlap(HostEntity sensor, HostEntity visitor) {
    if (!sensor.body().isValid() || !visitor.body().isValid() || !sensor.archetype().sensor()) {
      return false;
    }
    sought = visitor.body();
    found = false;
    sensor.body().forEachOverlap(seek);
    sought = null;
    return found;
  }

  private boolean seek(Body<HostEntity> other) {
    found |= other == sought;
    return !found;
  }

  private static long key(HostEntity a, HostEntity b) {
    int low = Math.min(a.bodySlot(), b.bodySlot());
    int high = Math.max(a.bodySlot(), b.bodySlot());
    return (long) low << 32 | high;
  }

  private int find(long key) {
    return Arrays.binarySearch(keys, 0, count, key);
  }

  /** Adds a visit; returns false if it lasts already. */
  private boolean add(HostEntity sensor, HostEntity visitor) {
    long key = key(sensor, visitor);
    int at = find(key);
    if (at >= 0) {
      return false;
    }
    at = -1 - at;
    if (count == keys.length) {
      keys = Arrays.copyOf(keys, 2 * count);
      pairs = Arrays.copyOf(pairs, 4 * count);
    }
    System.arraycopy(keys, at, keys, at + 1, count - at);
    System.arraycopy(pairs, 2 * at, pairs, 2 * at + 2, 2 * (count - at));
    keys[at] = key;
    pairs[2 * at] = sensor;
    pairs[2 * at + 1] = visitor;
    count++;
    return true;
  }

  private void remove(int at) {
    count--;
    System.arraycopy(keys, at + 1, keys, at, count - at);
    System.arraycopy(pairs, 2 * at + 2, pairs, 2 * at, 2 * (count - at));
    pairs[2 * count] = null;
    pairs[2 * count + 1] = null;
  }

  private void queue(byte kind, long key, HostEntity sensor, HostEntity visitor) {
    if (waiting == kinds.length) {
      kinds = Arrays.copyOf(kinds, 2 * waiting);
      waitingKeys = Arrays.copyOf(waitingKeys, 2 * waiting);
      waitingPairs = Arrays.copyOf(waitingPairs, 4 * waiting);
    }
    kinds[waiting] = kind;
    waitingKeys[waiting] = key;
    waitingPairs[2 * waiting] = sensor;
    waitingPairs[2 * waiting + 1] = visitor;
    waiting++;
  }
}
