package carom.physics;

import carom.physics.archive.ArchiveWriter;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.math.Limits;
import carom.physics.math.StateHash;
import java.util.Arrays;

/**
 * Records all calls that change a {@link World}, with their arguments, so that a {@link
 * WorldReplay} computes the same again, bit for bit, elsewhere:
 *
 * <pre>
 *   WorldRecorder recorder = new WorldRecorder(world, 1 &lt;&lt; 24, 1);
 *   ... the program goes on as usual ...
 *   byte[] recording = recorder.finish();
 * </pre>
 *
 * <p>A recording begins with the state that the world has. Calls that listeners make within a step
 * are recorded with the callback in which they were made. A call that is refused with an exception
 * is recorded, too, and refused again. A call takes 2 to 20 bytes, a step 5 and 8 for its hash.
 *
 * <p>Of a {@link CollisionFilter} the recording has its answers, by pair of shapes: each one that
 * is another than the last about that pair, 6 to 16 bytes. When a recording begins, the next step
 * asks the filter about all pairs.
 *
 * <p>A world without a recorder pays nothing but a comparison in each call. A recorder is no part
 * of the state. It is of the world's one thread.
 */
public final class WorldRecorder {
  /** Version of the format, which is refused unless it is this one. */
  static final int FORMAT = 1;

  /** First bytes of a recording. */
  static final long MAGIC = 0x4341_524f_4d43_414cL; // CAROMCAL

  /** Bit of the byte of a call that a callback made. */
  static final int NESTED = 0x80;

  /** Bit beside those of listeners: at the beginning there is a collision filter. */
  static final int FILTERED = 4;

  /** Byte of a hash of the state, among those of calls. */
  static final int HASH = 0x7f;

  /** Bytes that {@link #finish} adds: the end and the hash of all bytes before it. */
  private static final int TAIL = 9;

  private final World<?> world;
  private final int maxBytes;
  private final int stepsPerHash;
  private final ArchiveWriter values = new ArchiveWriter();
  private byte[] bytes = new byte[1024];
  private int length;
  private int steps;
  private boolean full;
  private boolean finished;
  private boolean hashDue;

  /** Callbacks since the last call from outside, and how deep in callbacks the world is. */
  private int callbacks;

  private int depth;

  /** True if the last call from outside is noted; false while one runs that is noted at its end. */
  private boolean noted;

  private final PairAnswers answers = new PairAnswers();

  /**
   * Begins to record a world, in place of any recorder that it has.
   *
   * @param world the world
   * @param maxBytes largest size of the recording, at least 1024; it ends before the call that
   *     doesn't fit
   * @param stepsPerHash after how many steps each the state's hash is recorded, 1 or more; 0 for
   *     after every call, which is slow and finds the first call that differs
   * @throws IllegalArgumentException if the present state alone is larger than {@code maxBytes}
   * @throws IllegalStateException during a step
   */
  public WorldRecorder(World<?> world, int maxBytes, int stepsPerHash) {
    if (maxBytes < 1024 || stepsPerHash < 0) {
      throw new IllegalArgumentException(
          "maxBytes=" + maxBytes + " stepsPerHash=" + stepsPerHash + "; at least 1024 and 0");
    }
    this.world = Limits.notNull("world", world);
    this.maxBytes = maxBytes;
    this.stepsPerHash = stepsPerHash;
    putLong(MAGIC);
    putInt(FORMAT);
    putInt(World.PHYSICS_VERSION);
    CallValues.passDef(values, world.firstDef());
    world.save(null).write(values);
    putValues();
    putInt(world.listeners() | (world.isFiltered() ? FILTERED : 0));
    putLong(world.stateHash());
    if (length + TAIL > maxBytes) {
      throw new IllegalArgumentException(
          "maxBytes=" + maxBytes + " is below the " + (length + TAIL) + " of the present state");
    }
    world.recorder(this);
  }

  /** Returns whether the recording has ended because the next call would not fit. */
  public boolean isFull() {
    return full;
  }

  /** Returns the number of bytes so far. */
  public int length() {
    return length;
  }

  /**
   * Ends the recording. The world is not recorded any more.
   *
   * @return the recording, for {@link WorldReplay}
   */
  public byte[] finish() {
    if (!finished) {
      settle();
      world.recorder(null);
      finished = true;
      put(Call.END.ordinal());
      putLong(hashOf(bytes, length));
    }
    return Arrays.copyOf(bytes, length);
  }

  static long hashOf(byte[] bytes, int length) {
    long h = StateHash.SEED;
    for (int i = 0; i < length; i++) {
      h = StateHash.mix(h, bytes[i]);
    }
    return StateHash.finish(h);
  }

  // ---------------------------------------------------------------- what the world tells

  /** Notes that a callback begins. */
  void enter() {
    callbacks++;
    depth++;
  }

  /** Notes that it ends. */
  void leave() {
    depth--;
  }

  /** Returns whether a callback is running. */
  boolean isInCallback() {
    return depth > 0;
  }

  /** Notes a call without arguments. */
  void note(Call call) {
    int at = begin(call);
    end(at);
  }

  /** Notes a call with whole numbers. */
  void note(Call call, int one) {
    int at = begin(call);
    putVar(one);
    end(at);
  }

  /** Notes a call with whole numbers. */
  void note(Call call, int one, int two) {
    int at = begin(call);
    putVar(one);
    putVar(two);
    end(at);
  }

  /** Notes a step. */
  void noteStep(float dt) {
    int at = begin(Call.STEP);
    putFloat(dt);
    end(at);
  }

  /** Notes a call of a body or joint with a number. */
  void note(Call call, int of, float a) {
    int at = begin(call);
    putVar(of);
    putFloat(a);
    end(at);
  }

  /** Notes a call of a body or joint with two numbers. */
  void note(Call call, int of, float a, float b) {
    int at = begin(call);
    putVar(of);
    putFloat(a);
    putFloat(b);
    end(at);
  }

  /** Notes a call of a body with three numbers. */
  void note(Call call, int of, float a, float b, float c) {
    int at = begin(call);
    putVar(of);
    putFloat(a);
    putFloat(b);
    putFloat(c);
    end(at);
  }

  /** Notes a call of a body with four numbers. */
  void note(Call call, int of, float a, float b, float c, float d) {
    int at = begin(call);
    putVar(of);
    putFloat(a);
    putFloat(b);
    putFloat(c);
    putFloat(d);
    end(at);
  }

  /** Notes a body's row. */
  void noteRow(int body, int[] row, int from) {
    int at = begin(Call.WRITE_ROW);
    putVar(body);
    for (int i = 0; i < Call.ROW; i++) {
      putInt(row[from + i]);
    }
    end(at);
  }

  /** Notes a call with an object. */
  void noteValue(Call call, Object value) {
    int at = begin(call);
    putValue(value);
    end(at);
  }

  /** Notes a call with two whole numbers and an object. */
  void noteValue(Call call, int one, int two, Object value) {
    int at = begin(call);
    putVar(one);
    putVar(two);
    putValue(value);
    end(at);
  }

  /**
   * Notes what a collision filter answered about two shapes, if its last answer about them was
   * another.
   */
  void noteAnswer(int bodyA, int shapeA, int bodyB, int shapeB, boolean meet) {
    if (full || !answers.set(ContactKey.of(bodyA, shapeA, bodyB, shapeB), !meet)) {
      return;
    }
    int at = length;
    Call call = meet ? Call.ALLOW_PAIR : Call.REFUSE_PAIR;
    if (noted) {
      put(NESTED | call.ordinal());
      putVar(callbacks);
    } else {
      put(call.ordinal());
    }
    putVar(bodyA);
    putVar(shapeA);
    putVar(bodyB);
    putVar(shapeB);
    end(at);
  }

  /**
   * Puts down the hash that the last call from outside left, if it is due. The next call does so
   * first; a call that is noted when it has begun to change the world has this done before.
   */
  void settle() {
    if (depth > 0) {
      return;
    }
    noted = false;
    if (!hashDue) {
      return;
    }
    hashDue = false;
    int at = length;
    put(HASH);
    putLong(world.stateHash());
    end(at);
  }

  // ---------------------------------------------------------------- bytes

  private int begin(Call call) {
    int at = length;
    if (depth > 0) {
      put(NESTED | call.ordinal());
      putVar(callbacks);
      return at;
    }
    settle();
    at = length;
    callbacks = 0;
    noted = true;
    put(call.ordinal());
    steps += call == Call.STEP ? 1 : 0;
    hashDue = stepsPerHash == 0 || (call == Call.STEP && steps % stepsPerHash == 0);
    return at;
  }

  /** Takes back what doesn't fit, and ends the recording there. */
  private void end(int from) {
    if (full || length + TAIL > maxBytes) {
      full = true;
      length = from;
    }
  }

  private void putValue(Object value) {
    values.clear();
    CallValues.pass(values, value);
    putValues();
  }

  private void putValues() {
    putVar(values.length());
    ensure(values.length());
    System.arraycopy(values.array(), 0, bytes, length, values.length());
    length += values.length();
    values.clear();
  }

  private void ensure(int more) {
    if (length + more > bytes.length) {
      bytes = Arrays.copyOf(bytes, Math.max(length + more, 2 * bytes.length));
    }
  }

  private void put(int value) {
    ensure(1);
    bytes[length++] = (byte) value;
  }

  /** Writes a whole number, seven bits a byte; small ones of either sign take one. */
  private void putVar(int value) {
    int rest = value << 1 ^ value >> 31;
    while ((rest & ~0x7f) != 0) {
      put(rest & 0x7f | 0x80);
      rest >>>= 7;
    }
    put(rest);
  }

  private void putInt(int value) {
    put(value >>> 24);
    put(value >>> 16);
    put(value >>> 8);
    put(value);
  }

  private void putLong(long value) {
    putInt((int) (value >>> 32));
    putInt((int) value);
  }

  private void putFloat(float value) {
    putInt(Float.floatToRawIntBits(value));
  }
}
