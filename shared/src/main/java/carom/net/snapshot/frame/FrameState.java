package carom.net.snapshot.frame;

import carom.net.codec.Quantizer;
import java.util.Arrays;
import java.util.function.Consumer;

/**
 * Holds a room's whole world at one tick, quantised once for all sessions, by entity slot. Filled
 * through {@link FrameRing}. Units: see {@link carom.net.codec.Quantizer}.
 */
public final class FrameState {

  /** Mask of the bits that a packed input has. */
  public static final long INPUT_MASK = (1L << 48) - 1;

  /** Number of bits in which teleports are counted. */
  public static final int TELEPORT_BITS = 4;

  private static final int FREE = Identities.FREE;
  private static final int TELEPORT_SHIFT = 24;
  private static final int IDENTITY = (1 << TELEPORT_SHIFT) - 1;
  private static final int MIN_LENGTH = 64;

  private final int capacity;
  private final Identities.Recycler pool;
  private int tick;
  private int limit;
  private boolean filling;
  private boolean hashed;
  private long hash;
  private Identities identities;

  /** True if another frame holds {@link #identities}, too, so that no entity can be added. */
  private boolean shared;

  private final PoseTable poses = new PoseTable();
  private FrameState previous;

  /** Number of slots for which there is room. */
  private int room;

  private final PlayerSet players = new PlayerSet();
  private long[] inputs = {};
  private final SlotSet changed = new SlotSet();
  private final SlotSet renamed = new SlotSet();

  /** The slots with an audience other than 0. */
  private final SlotSet special = new SlotSet();

  private int[] audience = {};

  FrameState(int capacity, Identities.Recycler pool) {
    this.capacity = capacity;
    this.pool = pool;
  }

  /**
   * Creates a frame of tick 0 outside of any ring: the state in which a level file places its
   * bodies, which server and client know without a datagram.
   *
   * @param capacity most entity slots, 1..65,535
   * @param fill puts the entities
   */
  public static FrameState of(int capacity, Consumer<FrameState> fill) {
    FrameState frame = new FrameState(capacity, new Identities.Recycler());
    frame.begin(0, null);
    fill.accept(frame);
    frame.end();
    return frame;
  }

  /**
   * Begins a frame.
   *
   * @param previous the frame before, or null for the first one
   */
  void begin(int tick, FrameState previous) {
    this.tick = tick;
    this.previous = previous;
    adopt(pool.take());
    limit = 0;
    special.clear();
    players.clear();
    filling = true;
    shared = false;
    hashed = false;
  }

  private void adopt(Identities next) {
    if (identities != null) {
      identities.holders--;
    }
    identities = next;
    identities.holders++;
  }

  /**
   * Puts an entity into the frame, quantising its pose. Of its velocities, only whether it stands
   * still is kept.
   *
   * @param slot entity id, 0..capacity - 1, put at most once per frame
   * @param generation 0..255, differs from that of the slot's previous entity
   * @param archetype 0..65,535
   * @param owner player id 0..1,023, or -1; see {@link Ownership}
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
    poses.put(
        slot,
        Quantizer.position(x),
        Quantizer.position(y),
        Quantizer.angle(angle),
        Quantizer.isStill(vx, vy, omega) ? 1 : 0);
  }

  /**
   * Puts an entity that is quantised already; refuses values outside the ranges of {@code
   * Quantizer}.
   */
  public void putQuantized(
      int slot, int generation, int archetype, int owner, int x, int y, int angle, boolean still) {
    check("x", x, -Quantizer.MAX_POSITION, Quantizer.MAX_POSITION);
    check("y", y, -Quantizer.MAX_POSITION, Quantizer.MAX_POSITION);
    check("angle", angle, 0, Quantizer.ANGLE_STEPS - 1);
    identify(slot, generation, archetype, owner);
    poses.put(slot, x, y, angle, still ? 1 : 0);
  }

  /**
   * Puts poses of entities that were {@linkplain #identify identified}; in steps, within the ranges
   * of {@code Quantizer}, which isn't checked.
   *
   * @param n how many
   * @param slot whose the poses are, or -1 for nobody's, from one index on
   * @param from that index
   * @param columns x, y, angle and still (1 or 0), n of each
   */
  public void putPoses(int n, int[] slot, int from, int[][] columns) {
    poses.putAll(n, slot, from, columns);
  }

  /**
   * Puts the entities of another frame into this one, which has none yet; their poses must follow
   * by {@link #putPoses}, and all that is told of them but audiences is the same. Nobody else can
   * be put.
   *
   * @param other of the same ring
   */
  public void identifyAs(FrameState other) {
    if (!filling || shared || identities.count > 0) {
      throw new IllegalStateException("identifyAs() after a put(), or outside begin() and end()");
    }
    adopt(other.identities);
    shared = true;
    ensure(other.limit);
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
    inputs[player] = packed & INPUT_MASK;
  }

  /**
   * Puts an entity into the frame whose pose must follow by {@link #putPoses}.
   *
   * @param slot as in {@link #put}, like the others
   */
  public void identify(int slot, int generation, int archetype, int owner) {
    if (!filling || shared) {
      throw new IllegalStateException(
          "put() after identifyAs(), or outside FrameRing.begin() and end()");
    }
    check("slot", slot, 0, capacity - 1);
    check("generation", generation, 0, 255);
    check("archetype", archetype, 0, 65_535);
    check("owner", owner, -1, Ownership.MAX);
    ensure(slot + 1);
    if (identities.kind[slot] != FREE) {
      throw new IllegalStateException("slot=" + slot + " was put twice");
    }
    identities.add(slot, archetype << 8 | generation, owner);
    limit = identities.limit;
  }

  /**
   * Sets who is told about an entity of this frame; 0 unless set. Only the caller of {@link
   * #audience} knows what the value means. A change of it counts as a change of the entity.
   */
  public void setAudience(int slot, int audience) {
    if (!filling || !alive(slot)) {
      throw new IllegalStateException("setAudience() of slot=" + slot + " before its put()");
    }
    if (special.has(slot)) {
      special.remove(slot);
    }
    if (audience == 0) {
      return;
    }
    if (slot >= this.audience.length) {
      this.audience = Arrays.copyOf(this.audience, room);
      special.ensure(room);
    }
    this.audience[slot] = audience;
    special.add(slot);
  }

  private static void check(String name, int value, int min, int max) {
    if (value < min || value > max) {
      throw new IllegalArgumentException(name + "=" + value + " is outside " + min + ".." + max);
    }
  }

  private void ensure(int length) {
    if (length > room) {
      // the same in all frames of a ring that reach as far, so that none grows for its neighbour
      int power = Integer.highestOneBit(Math.max(MIN_LENGTH, length) - 1) << 1;
      room = Math.max(MIN_LENGTH, Math.min(capacity, power));
      poses.ensure(room);
      changed.ensure(room);
      renamed.ensure(room);
    }
    identities.ensure(room);
  }

  /** Finds what changed since the frame before. */
  void end() {
    int known = previous == null ? 0 : previous.limit;
    limit = Math.max(limit, known);
    ensure(limit);
    changed.clear();
    renamed.clear();
    findRenamed(known);
    for (int word = 0; word << 6 < limit; word++) {
      long moved = word << 6 < known ? poses.differing(previous.poses, word, known) : 0;
      long bits = renamed.word(word) | (moved | readdressed(word)) & identities.living.word(word);
      if (bits != 0) {
        changed.addWord(word, bits);
      }
    }
    previous = null;
    filling = false;
  }

  /** Finds slots whose entity is another one than before; slots that are new count, too. */
  private void findRenamed(int known) {
    for (int word = 0; !shared && word << 6 < known; word++) {
      long bits = identities.differing(previous.identities, word, known);
      if (bits != 0) {
        renamed.addWord(word, bits);
      }
    }
    for (int slot = known; slot < limit; slot++) {
      renamed.add(slot);
    }
    if (previous != null && !shared && renamed.nextWord(0) < 0) {
      adopt(previous.identities);
    }
  }

  /** Returns those of 64 slots that have another audience than before. */
  private long readdressed(int word) {
    long specials = special.word(word);
    long before = previous == null ? 0 : previous.special.word(word);
    long result = specials ^ before;
    for (long both = specials & before; both != 0; both &= both - 1) {
      int slot = (word << 6) + Long.numberOfTrailingZeros(both);
      result |= audience[slot] != previous.audience[slot] ? Long.lowestOneBit(both) : 0;
    }
    return result;
  }

  /**
   * Sets how often an entity of this frame was teleported; 0 unless set. When the number changes, a
   * client shows the one place and then the other, and nothing between.
   *
   * @param teleports of which the lowest {@value #TELEPORT_BITS} bits count
   */
  public void setTeleports(int slot, int teleports) {
    if (!filling || shared || !alive(slot)) {
      throw new IllegalStateException("setTeleports() of slot=" + slot + " before its put()");
    }
    int sent = teleports & (1 << TELEPORT_BITS) - 1;
    identities.kind[slot] = identities.kind[slot] & IDENTITY | sent << TELEPORT_SHIFT;
  }

  /** Returns the tick after which this is the state. */
  public int tick() {
    return tick;
  }

  /** Returns the number of slots for which there is room. */
  int room() {
    return room;
  }

  /** Returns the number of living entities. */
  public int count() {
    return identities == null ? 0 : identities.count;
  }

  /**
   * Returns one more than the highest slot that was ever used up to this frame: the end for loops
   * over slots.
   */
  public int slotLimit() {
    return limit;
  }

  /** Returns whether a slot holds an entity; false for slots beyond {@link #slotLimit}. */
  public boolean alive(int slot) {
    return slot < limit && identities.kind[slot] != FREE;
  }

  /** Returns the generation of the slot's entity, 0..255. */
  public int generation(int slot) {
    return identities.kind[slot] & 0xff;
  }

  /** Returns the archetype of the slot's entity. */
  public int archetype(int slot) {
    return identities.kind[slot] >>> 8 & 0xffff;
  }

  /** Returns how often the slot's entity was teleported, modulo 16. */
  public int teleports(int slot) {
    return identities.kind[slot] >>> TELEPORT_SHIFT;
  }

  /** Returns the player id of the owner, or -1. */
  public int owner(int slot) {
    return Ownership.player(identities.owner[slot]);
  }

  /** Returns whose the entity is, see {@link Ownership}. */
  public int ownership(int slot) {
    return identities.owner[slot];
  }

  /** Returns the audience of the slot's entity, as {@link #setAudience} set it. */
  public int audience(int slot) {
    return special.has(slot) ? audience[slot] : 0;
  }

  /** Returns the x of the position, steps. */
  public int x(int slot) {
    return poses.x(slot);
  }

  /** Returns the y of the position, steps. */
  public int y(int slot) {
    return poses.y(slot);
  }

  /** Returns the angle, steps, 0..1,023. */
  public int angle(int slot) {
    return poses.angle(slot);
  }

  /** Returns whether the slot's entity stands still. */
  public boolean still(int slot) {
    return poses.still(slot);
  }

  /**
   * Returns a 64-bit hash of all slots' quantised state. Equal frames have equal hashes, also at
   * different ticks.
   */
  public long hash() {
    if (!hashed) {
      hash = computeHash();
      hashed = true;
    }
    return hash;
  }

  private long computeHash() {
    long h = identities.count;
    for (int slot = 0; slot < limit; slot++) {
      if (identities.kind[slot] != FREE) {
        h = mix(h, slot, identities.kind[slot]);
        h = mix(h, identities.owner[slot], angle(slot));
        h = mix(h, x(slot), y(slot));
        h = mix(h, still(slot) ? 1 : 0, 0);
      }
    }
    return h;
  }

  private static long mix(long hash, int a, int b) {
    long h = (hash ^ ((long) a << 32 | (b & 0xffffffffL))) * 0x9e3779b97f4a7c15L;
    return h ^ (h >>> 29);
  }

  /** Returns the packed input that a player's step to this tick consumed; 0 if there is none. */
  public long input(int player) {
    return players.has(player) ? inputs[player] : 0;
  }

  /**
   * Returns whether a slot is alive in both frames with the same entity, owner and archetype, and
   * was not teleported between.
   */
  public boolean sameIdentity(FrameState other, int slot) {
    return alive(slot)
        && other.alive(slot)
        && identities.kind[slot] == other.identities.kind[slot]
        && identities.owner[slot] == other.identities.owner[slot];
  }

  /** Copies the slot's pose. */
  public void pose(int slot, QuantizedPose out) {
    poses.read(slot, out);
  }

  /** Returns whether a slot is alive in both frames, as the same entity in the same pose. */
  boolean sameState(FrameState other, int slot) {
    return sameIdentity(other, slot) && poses.same(other.poses, slot);
  }

  /** Returns the slots that hold an entity. */
  public SlotSet living() {
    return identities.living;
  }

  /** Returns the slots whose entity, owner, archetype or teleports changed in this tick. */
  SlotSet renamed() {
    return renamed;
  }

  /** Returns the slots that changed in this tick. */
  public SlotSet changed() {
    return changed;
  }
}
