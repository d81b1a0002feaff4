package carom.net.snapshot;

import carom.net.codec.Quantizer;
import java.util.Arrays;
import java.util.function.Consumer;

/**
 * A room's whole world at one tick, quantised once for all sessions: a structure of int arrays, by
 * entity slot. Filled through {@link FrameRing}. Units: see {@link carom.net.codec.Quantizer}.
 */
public final class FrameState {

  /** Bits of a number of teleports that are sent. */
  static final int TELEPORT_BITS = 4;

  private static final int FREE = -1;
  private static final int TELEPORT_SHIFT = 24;
  private static final int IDENTITY = (1 << TELEPORT_SHIFT) - 1;
  private static final int MIN_LENGTH = 64;

  private final int capacity;
  private int tick;
  private int count;
  private int limit;
  private boolean filling;
  private boolean hashed;
  private long hash;
  private int[] kind = {};
  private int[] owner = {};
  private int[] x = {};
  private int[] y = {};
  private int[] angle = {};
  private int[] vx = {};
  private int[] vy = {};
  private int[] omega = {};
  private int[] changedTick = {};
  private int[] identityTick = {};
  private final PlayerSet players = new PlayerSet();
  private long[] inputs = {};
  private final SlotSet changed = new SlotSet();
  private final SlotSet renamed = new SlotSet();
  private final SlotSet living = new SlotSet();
  private int[] audience = {};

  FrameState(int capacity) {
    this.capacity = capacity;
  }

  /**
   * A frame of its own, outside of any ring, of tick 0: the state that a level file places its
   * bodies in, which server and client know without a word.
   *
   * @param capacity most entity slots, 1..65,535
   * @param fill puts the entities
   */
  public static FrameState of(int capacity, Consumer<FrameState> fill) {
    FrameState frame = new FrameState(capacity);
    frame.begin(0);
    fill.accept(frame);
    frame.end(null);
    return frame;
  }

  void begin(int tick) {
    this.tick = tick;
    count = 0;
    Arrays.fill(kind, 0, limit, FREE);
    limit = 0;
    players.clear();
    filling = true;
    hashed = false;
  }

  /**
   * Puts an entity into the frame, quantising its state.
   *
   * @param slot entity id, 0..capacity - 1, put at most once per frame
   * @param generation 0..255, differs from that of the slot's previous entity
   * @param archetype 0..65,535
   * @param owner player id 0..1,023, or -1
   * @param x metres
   * @param y metres
   * @param angle radians
   * @param vx metres per second
   * @param vy metres per second
   * @param omega radians per second
   */
  public void put(
      int slot,
      int generation,
      int archetype,
      int owner,
      float x,
      float y,
      float angle,
      float vx,
      float vy,
      float omega) {
    identify(slot, generation, archetype, owner);
    this.x[slot] = Quantizer.position(x);
    this.y[slot] = Quantizer.position(y);
    this.angle[slot] = Quantizer.angle(angle);
    this.vx[slot] = Quantizer.velocity(vx);
    this.vy[slot] = Quantizer.velocity(vy);
    this.omega[slot] = Quantizer.omega(omega);
  }

  /**
   * As {@link #put}, already quantised; values outside the ranges of {@code Quantizer} are refused.
   */
  public void putQuantized(
      int slot,
      int generation,
      int archetype,
      int owner,
      int x,
      int y,
      int angle,
      int vx,
      int vy,
      int omega) {
    check("x", x, -Quantizer.MAX_POSITION, Quantizer.MAX_POSITION);
    check("y", y, -Quantizer.MAX_POSITION, Quantizer.MAX_POSITION);
    check("angle", angle, 0, Quantizer.ANGLE_STEPS - 1);
    check("vx", vx, -Quantizer.MAX_VELOCITY, Quantizer.MAX_VELOCITY);
    check("vy", vy, -Quantizer.MAX_VELOCITY, Quantizer.MAX_VELOCITY);
    check("omega", omega, -Quantizer.MAX_OMEGA, Quantizer.MAX_OMEGA);
    identify(slot, generation, archetype, owner);
    this.x[slot] = x;
    this.y[slot] = y;
    this.angle[slot] = angle;
    this.vx[slot] = vx;
    this.vy[slot] = vy;
    this.omega[slot] = omega;
  }

  /**
   * Puts the motions of entities that were {@linkplain #identify identified}; in steps, within the
   * ranges of {@code Quantizer}, which isn't checked.
   *
   * @param n how many
   * @param slot of each entity
   * @param from of each entity where its numbers are in the columns
   * @param columns x, y, angle, vx, vy, omega
   */
  public void putMotions(int n, int[] slot, int[] from, int[][] columns) {
    gather(n, slot, from, columns[0], x);
    gather(n, slot, from, columns[1], y);
    gather(n, slot, from, columns[2], angle);
    gather(n, slot, from, columns[3], vx);
    gather(n, slot, from, columns[4], vy);
    gather(n, slot, from, columns[5], omega);
  }

  private static void gather(int n, int[] slot, int[] from, int[] column, int[] to) {
    for (int i = 0; i < n; i++) {
      to[slot[i]] = column[from[i]];
    }
  }

  /**
   * Puts the entities of another frame into this one, which has none yet; their motions must follow
   * by {@link #putMotions}, and all that is told of them but audiences is the same.
   *
   * @param other of the same ring
   */
  public void identifyAs(FrameState other) {
    if (!filling || count > 0) {
      throw new IllegalStateException("identifyAs() after a put(), or outside begin() and end()");
    }
    ensure(other.limit);
    System.arraycopy(other.kind, 0, kind, 0, other.limit);
    System.arraycopy(other.owner, 0, owner, 0, other.limit);
    Arrays.fill(audience, 0, other.limit, 0);
    count = other.count;
    limit = other.limit;
  }

  /**
   * Puts the input into the frame that a player's step to this tick consumed.
   *
   * @param player id, 0..1,023
   * @param packed 48 bits, higher ones are dropped
   */
  public void putInput(int player, long packed) {
    players.add(player);
    if (player >= inputs.length) {
      inputs = Arrays.copyOf(inputs, Math.max(16, Math.max(player + 1, 2 * inputs.length)));
    }
    inputs[player] = packed & RelayCodec.INPUT_MASK;
  }

  /**
   * Puts an entity into the frame whose motion must follow by {@link #putMotions}.
   *
   * @param slot as in {@link #put}, like the others
   */
  public void identify(int slot, int generation, int archetype, int owner) {
    if (!filling) {
      throw new IllegalStateException("put() outside FrameRing.begin() and end()");
    }
    check("slot", slot, 0, capacity - 1);
    check("generation", generation, 0, 255);
    check("archetype", archetype, 0, 65_535);
    check("owner", owner, -1, PlayerId.MAX);
    ensure(slot + 1);
    if (kind[slot] != FREE) {
      throw new IllegalStateException("slot=" + slot + " was put twice");
    }
    kind[slot] = archetype << 8 | generation;
    this.owner[slot] = owner;
    audience[slot] = 0;
    count++;
    limit = Math.max(limit, slot + 1);
  }

  /**
   * Says who is told about an entity of this frame, in the terms of whoever asks for {@link
   * #audience}; 0 unless said. A change of it counts as a change of the entity.
   */
  public void setAudience(int slot, int audience) {
    if (!filling || !alive(slot)) {
      throw new IllegalStateException("setAudience() of slot=" + slot + " before its put()");
    }
    this.audience[slot] = audience;
  }

  private static void check(String name, int value, int min, int max) {
    if (value < min || value > max) {
      throw new IllegalArgumentException(name + "=" + value + " is outside " + min + ".." + max);
    }
  }

  private void ensure(int length) {
    if (length <= kind.length) {
      return;
    }
    int old = kind.length;
    int grown = Math.max(MIN_LENGTH, Math.min(capacity, Math.max(length, 2 * old)));
    kind = Arrays.copyOf(kind, grown);
    Arrays.fill(kind, old, grown, FREE);
    owner = Arrays.copyOf(owner, grown);
    x = Arrays.copyOf(x, grown);
    y = Arrays.copyOf(y, grown);
    angle = Arrays.copyOf(angle, grown);
    vx = Arrays.copyOf(vx, grown);
    vy = Arrays.copyOf(vy, grown);
    omega = Arrays.copyOf(omega, grown);
    changedTick = Arrays.copyOf(changedTick, grown);
    identityTick = Arrays.copyOf(identityTick, grown);
    audience = Arrays.copyOf(audience, grown);
    changed.ensure(grown);
    renamed.ensure(grown);
    living.ensure(grown);
  }

  /** Finds what changed since {@code previous}, the frame before, or null for the first one. */
  void end(FrameState previous) {
    if (previous != null) {
      ensure(previous.limit);
      limit = Math.max(limit, previous.limit);
    }
    changed.clear();
    int known = previous == null ? 0 : previous.limit;
    findDifferences(previous, known);
    for (int slot = 0; slot < known; slot++) {
      // a free slot's owner means nothing
      int identity =
          kind[slot] ^ previous.kind[slot]
              | (owner[slot] ^ previous.owner[slot]) & ~(kind[slot] >> 31);
      identityTick[slot] = identity != 0 ? tick : previous.identityTick[slot];
      changedTick[slot] = changedTick[slot] != 0 ? tick : previous.changedTick[slot];
    }
    for (int slot = known; slot < limit; slot++) {
      identityTick[slot] = tick;
      changedTick[slot] = tick;
    }
    changed.addEqual(changedTick, limit, tick);
    renamed.clear();
    renamed.addEqual(identityTick, limit, tick);
    living.clear();
    living.addNotNegative(kind, limit);
    filling = false;
  }

  /** Leaves in {@link #changedTick} what isn't zero where a slot differs; a loop for vectors. */
  private void findDifferences(FrameState previous, int known) {
    int[] out = changedTick;
    for (int slot = 0; slot < known; slot++) {
      out[slot] =
          owner[slot] ^ previous.owner[slot]
              | audience[slot] ^ previous.audience[slot]
              | x[slot] ^ previous.x[slot]
              | y[slot] ^ previous.y[slot]
              | angle[slot] ^ previous.angle[slot];
    }
    for (int slot = 0; slot < known; slot++) {
      int motion =
          vx[slot] ^ previous.vx[slot]
              | vy[slot] ^ previous.vy[slot]
              | omega[slot] ^ previous.omega[slot];
      // what a free slot holds means nothing
      out[slot] = kind[slot] ^ previous.kind[slot] | (out[slot] | motion) & ~(kind[slot] >> 31);
    }
  }

  private boolean sameMotion(FrameState other, int slot) {
    return x[slot] == other.x[slot]
        && y[slot] == other.y[slot]
        && angle[slot] == other.angle[slot]
        && vx[slot] == other.vx[slot]
        && vy[slot] == other.vy[slot]
        && omega[slot] == other.omega[slot];
  }

  /**
   * Says how often an entity of this frame was put elsewhere instead of moving there; 0 unless
   * said. Between two numbers there is no way: a client shows the one place and then the other.
   *
   * @param teleports of which the lowest {@value #TELEPORT_BITS} bits count
   */
  public void setTeleports(int slot, int teleports) {
    if (!filling || !alive(slot)) {
      throw new IllegalStateException("setTeleports() of slot=" + slot + " before its put()");
    }
    kind[slot] = kind[slot] & IDENTITY | (teleports & (1 << TELEPORT_BITS) - 1) << TELEPORT_SHIFT;
  }

  /** The tick this frame is the state after. */
  public int tick() {
    return tick;
  }

  /** Entities alive. */
  public int count() {
    return count;
  }

  /**
   * One more than the highest slot that was ever used up to this frame: the end for loops over
   * slots.
   */
  public int slotLimit() {
    return limit;
  }

  /** Whether a slot holds an entity; false for slots beyond {@link #slotLimit}. */
  public boolean alive(int slot) {
    return slot < limit && kind[slot] != FREE;
  }

  /** Generation of the slot's entity, 0..255. */
  public int generation(int slot) {
    return kind[slot] & 0xff;
  }

  /** Archetype of the slot's entity. */
  public int archetype(int slot) {
    return kind[slot] >>> 8 & 0xffff;
  }

  /** How often the slot's entity was put elsewhere, 0..15, modulo 16. */
  public int teleports(int slot) {
    return kind[slot] >>> TELEPORT_SHIFT;
  }

  /** Player id of the owner, or -1. */
  public int owner(int slot) {
    return owner[slot];
  }

  /** Who is told about the slot's entity, as {@link #setAudience} said. */
  public int audience(int slot) {
    return audience[slot];
  }

  /** Position, steps. */
  public int x(int slot) {
    return x[slot];
  }

  /** Position, steps. */
  public int y(int slot) {
    return y[slot];
  }

  /** Angle, steps, 0..1,023. */
  public int angle(int slot) {
    return angle[slot];
  }

  /** Velocity, steps. */
  public int vx(int slot) {
    return vx[slot];
  }

  /** Velocity, steps. */
  public int vy(int slot) {
    return vy[slot];
  }

  /** Angular velocity, steps. */
  public int omega(int slot) {
    return omega[slot];
  }

  /**
   * The last tick at which anything of the slot's quantised state changed, liveness and identity
   * included. A slot never used has never changed: -1.
   */
  public int changedTick(int slot) {
    return slot < limit ? changedTick[slot] : -1;
  }

  /**
   * 64-bit hash of all slots' quantised state; equal frames have equal hashes, whatever their tick.
   */
  public long hash() {
    if (!hashed) {
      hash = computeHash();
      hashed = true;
    }
    return hash;
  }

  private long computeHash() {
    long h = count;
    for (int slot = 0; slot < limit; slot++) {
      if (kind[slot] != FREE) {
        h = mix(h, slot, kind[slot]);
        h = mix(h, owner[slot], angle[slot]);
        h = mix(h, x[slot], y[slot]);
        h = mix(h, vx[slot], vy[slot]);
        h = mix(h, omega[slot], 0);
      }
    }
    return h;
  }

  private static long mix(long hash, int a, int b) {
    long h = (hash ^ ((long) a << 32 | (b & 0xffffffffL))) * 0x9e3779b97f4a7c15L;
    return h ^ (h >>> 29);
  }

  /** Whether the frame holds the input of a player. */
  public boolean hasInput(int player) {
    return players.has(player);
  }

  /** The packed input that a player's step to this tick consumed; 0 when there is none. */
  public long input(int player) {
    return players.has(player) ? inputs[player] : 0;
  }

  /**
   * Whether a slot is of the same entity, owner and archetype in both frames, alive, and wasn't put
   * elsewhere between.
   */
  boolean sameIdentity(FrameState other, int slot) {
    return alive(slot)
        && other.alive(slot)
        && kind[slot] == other.kind[slot]
        && owner[slot] == other.owner[slot];
  }

  /** Whether a slot of this frame is the same as in an older frame of its ring; as above. */
  boolean sameIdentitySince(FrameState older, int slot) {
    return identityTick[slot] <= older.tick ? alive(slot) : sameIdentity(older, slot);
  }

  /** Copies the slot's motion. */
  void motion(int slot, Motion out) {
    out.x = x[slot];
    out.y = y[slot];
    out.angle = angle[slot];
    out.vx = vx[slot];
    out.vy = vy[slot];
    out.omega = omega[slot];
  }

  /** Whether a slot is the same entity in the same motion in both frames, and alive. */
  boolean sameState(FrameState other, int slot) {
    return sameIdentity(other, slot) && sameMotion(other, slot);
  }

  /** The slots that hold an entity. */
  SlotSet living() {
    return living;
  }

  /** The slots whose entity, owner or archetype changed in this very tick, or was put elsewhere. */
  SlotSet renamed() {
    return renamed;
  }

  /** The slots that changed in this very tick. */
  SlotSet changed() {
    return changed;
  }
}
