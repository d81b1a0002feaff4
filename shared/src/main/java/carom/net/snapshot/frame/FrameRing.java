package carom.net.snapshot.frame;

/**
 * Keeps the last {@link #SIZE} frame states of a room. The server captures each tick like this:
 *
 * <pre>{@code
 * FrameState frame = ring.begin(tick);
 * for (each entity) frame.put(id, generation, archetype, owner, x, y, angle, vx, vy, omega);
 * ring.end();
 * }</pre>
 *
 * One thread. Frames grow with the highest slot in use; no allocation otherwise.
 */
public final class FrameRing {

  /** Number of bits of a baseline's age in ticks. */
  public static final int AGE_BITS = 6;

  /** Number of frames kept; a baseline is at most {@code SIZE - 1} ticks old. */
  public static final int SIZE = 1 << AGE_BITS;

  private static final int MASK = SIZE - 1;

  private final int capacity;
  private final FrameState[] frames = new FrameState[SIZE];
  private final EventRing events = new EventRing();
  private final WaitingInputs waiting = new WaitingInputs();
  private final SlotSet asLevel = new SlotSet();
  private final ChangedSlots changes = new ChangedSlots(this);

  /**
   * Ticks at which slots changed last, up to the newest frame; {@link #oldTicks} has those up to
   * the frames that have left the ring.
   */
  private final SlotTicks changedTicks = new SlotTicks();

  private final SlotTicks oldTicks = new SlotTicks();
  private FrameState level;
  private float gravityX;
  private float gravityY;
  private int firstTick = -1;
  private long ended;
  private boolean begun;

  /**
   * Creates an empty ring.
   *
   * @param capacity most entity slots of a frame, 1..65,535
   */
  public FrameRing(int capacity) {
    if (capacity < 1 || capacity > 65_535) {
      throw new IllegalArgumentException("capacity=" + capacity + " is outside 1..65535");
    }
    this.capacity = capacity;
    Identities.Recycler pool = new Identities.Recycler();
    for (int i = 0; i < SIZE; i++) {
      frames[i] = new FrameState(capacity, pool);
    }
  }

  /**
   * Sets what every client knows before the first datagram: the entities as the level file places
   * them. An entity that is so in the ring's first frame costs nothing until it moves.
   *
   * @param state made by {@link FrameState#of}; the clients' decoders must be given the same
   * @throws IllegalStateException after the first frame
   */
  public void level(FrameState state) {
    if (ended > 0 || begun) {
      throw new IllegalStateException("level() after the first frame was begun");
    }
    level = state;
  }

  /**
   * Sets gravity, m/s^2, before the sessions' encoders are made; it is zero until then.
   *
   * @param x the clients' decoders must be given the same
   */
  public void gravity(float x, float y) {
    gravityX = x;
    gravityY = y;
  }

  /** Returns what falling bodies gain along x, m/s^2. */
  public float gravityX() {
    return gravityX;
  }

  /** Returns what falling bodies gain along y, m/s^2. */
  public float gravityY() {
    return gravityY;
  }

  /** Returns what has changed since each older frame. */
  public ChangedSlots changes() {
    return changes;
  }

  /** Returns the state that all clients know from the level, or null. */
  public FrameState level() {
    return level;
  }

  /** Returns the inputs of the ticks after the newest frame; empty when it begins. */
  public WaitingInputs waiting() {
    return waiting;
  }

  /** Returns the slots that were in the first frame as the level has them. */
  public SlotSet asLevel() {
    return asLevel;
  }

  /** Returns the tick of the first frame that was ever ended; -1 before it. */
  public int firstTick() {
    return firstTick;
  }

  /** Returns the most entity slots of a frame. */
  public int capacity() {
    return capacity;
  }

  /**
   * Starts the frame of a tick; all slots are free until {@link FrameState#put}.
   *
   * @param tick not negative and greater than the newest frame's
   */
  public FrameState begin(int tick) {
    FrameState newest = newest();
    if (tick < 0 || (newest != null && tick <= newest.tick())) {
      throw new IllegalArgumentException(
          "tick=" + tick + " must follow " + (newest == null ? -1 : newest.tick()));
    }
    FrameState frame = frames[(int) ended & MASK];
    if (ended >= SIZE && !begun) {
      raise(oldTicks, frame);
    }
    frame.begin(tick, newest);
    waiting.clear();
    begun = true;
    return frame;
  }

  /** Ends the frame that was begun: from now on it is the newest and doesn't change. */
  public void end() {
    if (!begun) {
      throw new IllegalStateException("end() without begin()");
    }
    FrameState frame = frames[(int) ended & MASK];
    frame.end();
    changedTicks.ensure(frame.room());
    oldTicks.ensure(frame.room());
    raise(changedTicks, frame);
    if (ended == 0) {
      firstTick = frame.tick();
      compareWithLevel(frame);
    }
    ended++;
    begun = false;
  }

  private static void raise(SlotTicks ticks, FrameState frame) {
    SlotSet changed = frame.changed();
    for (int word = changed.nextWord(0); word >= 0; word = changed.nextWord(word + 1)) {
      ticks.raise(word, changed.word(word), frame.tick());
    }
  }

  /**
   * Returns the last tick at which the state of a slot changed, liveness and identity included; -1
   * for a slot that was never used.
   */
  public int changedTick(int slot) {
    return changedTicks.get(slot);
  }

  /**
   * Returns the newest frame in which a slot is as it was in a tick, or null when the ring has
   * none.
   *
   * @param tick of an older frame of the ring, or of one that has left it
   */
  public FrameState lastLike(int slot, int tick) {
    int back = count() - 1;
    if (back < 0
        || oldTicks.get(slot) > tick
        || back(back).tick() > tick && back(back).changed().has(slot)) {
      return null;
    }
    while (back > 0 && (back(back).tick() < tick || !back(back - 1).changed().has(slot))) {
      back--;
    }
    return back(back);
  }

  private void compareWithLevel(FrameState first) {
    for (int slot = 0; level != null && slot < level.slotLimit(); slot++) {
      if (level.sameState(first, slot)) {
        asLevel.ensure(slot + 1);
        asLevel.add(slot);
      }
    }
  }

  /** Returns the room's events. */
  public EventRing events() {
    return events;
  }

  /** Returns the newest ended frame, or null before the first. */
  public FrameState newest() {
    return back(0);
  }

  /** Returns the frame of a tick, or null when the ring doesn't hold it. */
  public FrameState at(int tick) {
    int back = backTo(tick);
    return back < 0 ? null : back(back);
  }

  /** Returns how many frames before the newest the frame of a tick is; -1 for none. */
  public int backTo(int tick) {
    FrameState newest = newest();
    if (newest == null || tick > newest.tick()) {
      return -1;
    }
    // Without gaps the first look hits; with gaps the frame is nearer to the newest.
    for (int back = Math.min(newest.tick() - tick, count() - 1); back >= 0; back--) {
      int there = back(back).tick();
      if (there >= tick) {
        return there == tick ? back : -1;
      }
    }
    return -1;
  }

  /**
   * Returns the number of ended frames held. While a frame is being filled, it has taken the oldest
   * one's place.
   */
  int count() {
    return (int) Math.min(ended, begun ? MASK : SIZE);
  }

  /** Returns the frame that many frames before the newest, or null if the ring has none. */
  public FrameState back(int frames) {
    return frames < count() ? this.frames[(int) (ended - 1 - frames) & MASK] : null;
  }
}
