package carom.physics.dynamics.joint;

import carom.physics.archive.Archive;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.store.ColumnHash;
import carom.physics.dynamics.store.Slots;
import carom.physics.dynamics.store.Stamp;
import carom.physics.math.StateHash;
import java.util.Arrays;

/**
 * All joints of a world as a structure of arrays; the index is the joint's slot, which is also the
 * order in which joints are solved.
 *
 * <p>Slots are reused last in, first out; each reuse has another generation. Each body has a list
 * of its joints ({@link JointLists}). The free list is part of the state, so that a restored world
 * does the same again.
 *
 * <p>What a step changes, impulses and forces, is copied whenever the state is; all else only if
 * something of it changed; the code that writes it must call {@link #coldChanged}.
 */
public final class JointStore {
  /** Type of a free slot. */
  public static final byte FREE = -1;

  /** Two points coincide; motor, limits and spring act on the angle. */
  public static final byte REVOLUTE = 0;

  /** The distance of two points is held, limited, or sprung. */
  public static final byte DISTANCE = 1;

  /** B slides along an axis of A and doesn't turn. */
  public static final byte PRISMATIC = 2;

  /** Two points and the angle are held, rigidly or by springs. */
  public static final byte WELD = 3;

  /** B slides along an axis of A by a spring, and turns by a motor. */
  public static final byte WHEEL = 4;

  /** B is drawn to a pose relative to A with limited force. */
  public static final byte MOTOR = 5;

  /** A point of B is drawn to a point of the world with limited force. */
  public static final byte MOUSE = 6;

  /** The angles of two bodies are coupled by a ratio. */
  public static final byte GEAR = 7;

  /** A translation of B is coupled to the angle of A by a ratio. */
  public static final byte RACK = 8;

  /** The lengths to two points of the world are coupled by a ratio. */
  public static final byte PULLEY = 9;

  /** Flag: the bodies collide with each other. */
  public static final byte COLLIDE = 1;

  /** Flag: the coordinate is limited. */
  public static final byte LIMITED = 2;

  /** Flag: the motor runs. */
  public static final byte DRIVEN = 4;

  /** Flag: there is a spring on the coordinate. */
  public static final byte SPRUNG = 8;

  /** Flag: full turns are counted. */
  public static final byte WINDS = 16;

  private static final double TWO_PI = 2 * Math.PI;

  private static final int FIRST_CAPACITY = 16;

  /** The last of the float arrays change in every step: those from this one on. */
  static final int HOT = 21;

  /** {@link #FREE} or one of the types. */
  public byte[] type = new byte[FIRST_CAPACITY];

  /** Flags, added up. */
  public byte[] flags = new byte[FIRST_CAPACITY];

  /** Slot of body A, -1 for the world. */
  public int[] bodyA = new int[FIRST_CAPACITY];

  /** Slot of body B. */
  public int[] bodyB = new int[FIRST_CAPACITY];

  /** Anchor in A's frame (the world's without A), m. */
  public float[] anchorAx = new float[FIRST_CAPACITY];

  /** Anchor in A's frame, m. */
  public float[] anchorAy = new float[FIRST_CAPACITY];

  /** Anchor in B's frame, m. */
  public float[] anchorBx = new float[FIRST_CAPACITY];

  /** Anchor in B's frame, m. */
  public float[] anchorBy = new float[FIRST_CAPACITY];

  /** Unit axis of prismatic and wheel in A's frame. */
  public float[] axisX = new float[FIRST_CAPACITY];

  /** Unit axis in A's frame. */
  public float[] axisY = new float[FIRST_CAPACITY];

  /** Rotation of B relative to A that counts as angle 0. */
  public float[] refCos = new float[FIRST_CAPACITY];

  /** Sine of that rotation. */
  public float[] refSin = new float[FIRST_CAPACITY];

  /** Coordinate where the spring is at ease: length, translation (m) or angle (rad). */
  public float[] rest = new float[FIRST_CAPACITY];

  /** Lower limit of the coordinate. */
  public float[] lower = new float[FIRST_CAPACITY];

  /** Upper limit of the coordinate. */
  public float[] upper = new float[FIRST_CAPACITY];

  /** Goal of the motor, m/s or rad/s. */
  public float[] motorSpeed = new float[FIRST_CAPACITY];

  /** Most the motor gives, N or N m. */
  public float[] motorMax = new float[FIRST_CAPACITY];

  /** Frequency of the spring, 1/s. */
  public float[] hertz = new float[FIRST_CAPACITY];

  /** Damping ratio of the spring. */
  public float[] damping = new float[FIRST_CAPACITY];

  /** Frequency of the angular spring of weld and motor joints, 1/s. */
  public float[] angularHertz = new float[FIRST_CAPACITY];

  /** Damping ratio of the angular spring. */
  public float[] angularDamping = new float[FIRST_CAPACITY];

  /** Most a motor or mouse joint pulls with, N. */
  public float[] maxForce = new float[FIRST_CAPACITY];

  /** Most a motor joint turns with, N m. */
  public float[] maxTorque = new float[FIRST_CAPACITY];

  /** Force beyond which the joint breaks, N. */
  public float[] breakForce = new float[FIRST_CAPACITY];

  /** Torque beyond which the joint breaks, N m. */
  public float[] breakTorque = new float[FIRST_CAPACITY];

  /** Impulse of the last substep: along x, or along the perpendicular, or of the rod, N s. */
  public float[] impulseX = new float[FIRST_CAPACITY];

  /** Impulse of the last substep along y, N s; of a prismatic joint the angular one, N m s. */
  public float[] impulseY = new float[FIRST_CAPACITY];

  /** Angular impulse of the last substep, N m s. */
  public float[] impulseW = new float[FIRST_CAPACITY];

  /** Impulse of the spring in the last substep. */
  public float[] springImpulse = new float[FIRST_CAPACITY];

  /** Impulse of the motor in the last substep. */
  public float[] motorImpulse = new float[FIRST_CAPACITY];

  /** Impulse of the lower limit in the last substep, not negative. */
  public float[] lowerImpulse = new float[FIRST_CAPACITY];

  /** Impulse of the upper limit in the last substep, not negative. */
  public float[] upperImpulse = new float[FIRST_CAPACITY];

  /** Force on B in the last substep, N. */
  public float[] forceX = new float[FIRST_CAPACITY];

  /** Force on B in the last substep, N. */
  public float[] forceY = new float[FIRST_CAPACITY];

  /** Torque on B in the last substep, N m. */
  public float[] torque = new float[FIRST_CAPACITY];

  /**
   * Gear, rack and pulley: what B does by what A does. Revolute: the angle between the teeth of a
   * ratchet, rad, in the direction in which it is free; 0 for none.
   */
  public float[] ratio = new float[FIRST_CAPACITY];

  /**
   * Origin from which A's length or angle counts: of a pulley a point of the world, m; of a gear
   * the rotation that counts as angle 0.
   */
  public float[] baseAx = new float[FIRST_CAPACITY];

  /** See {@link #baseAx}. */
  public float[] baseAy = new float[FIRST_CAPACITY];

  /** Origin from which B's length or angle counts; see {@link #baseAx}. */
  public float[] baseBx = new float[FIRST_CAPACITY];

  /** See {@link #baseBx}. */
  public float[] baseBy = new float[FIRST_CAPACITY];

  /**
   * Full turns of A, if they are counted, and its angle when they last were, rad; of a ratchet the
   * teeth that it has passed.
   */
  int[] turnsA = new int[FIRST_CAPACITY];

  float[] lastA = new float[FIRST_CAPACITY];

  /** Full turns of B, or of B relative to A, and the angle when they last were counted, rad. */
  int[] turnsB = new int[FIRST_CAPACITY];

  float[] lastB = new float[FIRST_CAPACITY];

  /** All float arrays of archives, the cold ones first. */
  float[][] floats = gather();

  /** Each body's joints. */
  final JointLists lists = new JointLists(FIRST_CAPACITY);

  /** A bit per slot: whether the solver must look at the joint; follows from the bodies. */
  private long[] awake = new long[1];

  final Slots slots = new Slots();
  private final Stamp cold = new Stamp();
  private int version;

  /** By slot: how often settings were changed; no part of the state. */
  private int[] changes = {};

  /** Hash of what is cold, as it was at {@link #hashed}. */
  private long coldHash = hashCold();

  private final Stamp hashed = new Stamp();
  private final ColumnHash columns = new ColumnHash();

  /** Makes an empty store. */
  public JointStore() {}

  /** Returns the number of joints. */
  public int count() {
    return slots.count();
  }

  /** Returns one more than the largest slot ever used: the bound of loops over all slots. */
  public int slots() {
    return slots.bound();
  }

  /** Returns how often a slot was given back: what {@link #alive} expects of a handle made now. */
  public int generation(int slot) {
    return slots.generation(slot);
  }

  /** Returns whether the joint of a handle with this slot and generation is still alive. */
  public boolean alive(int slot, int expected) {
    return slot < slots.bound() && slots.generation(slot) == expected && type[slot] != FREE;
  }

  /** Returns the first end of a joint of a body, -1 for none. The joint is the end divided by 2. */
  public int firstEnd(int body) {
    return lists.first(body);
  }

  /** Returns the next end of a joint of the same body, -1 for none. */
  public int nextEnd(int end) {
    return lists.next(end);
  }

  /** Returns the slot of the body at the other end of a joint, -1 for the world. */
  public int other(int end) {
    return (end & 1) == 0 ? bodyB[end >> 1] : bodyA[end >> 1];
  }

  /** Takes a slot for a joint between two bodies; all its numbers are zero. */
  public int allocate(byte newType, int a, int b) {
    int slot = slots.take();
    if (slot == type.length) {
      grow();
    }
    for (float[] field : floats) {
      field[slot] = 0;
    }
    ratio[slot] = 0;
    baseAx[slot] = 0;
    baseAy[slot] = 0;
    baseBx[slot] = 0;
    baseBy[slot] = 0;
    turnsA[slot] = 0;
    lastA[slot] = 0;
    turnsB[slot] = 0;
    lastB[slot] = 0;
    type[slot] = newType;
    flags[slot] = 0;
    bodyA[slot] = a;
    bodyB[slot] = b;
    refCos[slot] = 1;
    axisX[slot] = 1;
    breakForce[slot] = Float.POSITIVE_INFINITY;
    breakTorque[slot] = Float.POSITIVE_INFINITY;
    lists.link(2 * slot, a);
    lists.link(2 * slot + 1, b);
    coldChanged();
    return slot;
  }

  /** Gives the slot of a joint back. */
  public void release(int slot) {
    setAwake(slot, false);
    lists.unlink(2 * slot, bodyA[slot]);
    lists.unlink(2 * slot + 1, bodyB[slot]);
    type[slot] = FREE;
    clearFree(slot);
    slots.release(slot);
    coldChanged();
  }

  /** Gives free slots out in ascending order from now on, until others are released. */
  public void sortFree() {
    slots.sortFree();
    coldChanged();
  }

  /** Sets what is hot to what free slots hold, so that it is the same in equal states. */
  void clearFree(int slot) {
    forget(slot);
    flags[slot] = 0;
  }

  /** Notes that something was written that steps don't change. Must be called then. */
  public void coldChanged() {
    cold.change();
    version++;
  }

  /** Notes that a setting of a joint was changed. */
  public void settingChanged(int slot) {
    if (slot >= changes.length) {
      changes = Arrays.copyOf(changes, type.length);
    }
    changes[slot]++;
    coldChanged();
  }

  /** Returns how often settings of a slot's joints were changed. */
  public int changes(int slot) {
    return slot < changes.length ? changes[slot] : 0;
  }

  /**
   * Returns a number that changes whenever the solver may find other joints than before: others are
   * awake, or their bodies or parameters changed.
   */
  public int version() {
    return version;
  }

  /** Sets whether the solver must look at a joint. */
  public void setAwake(int slot, boolean value) {
    version++;
    int word = slot >> 6;
    if (word >= awake.length) {
      awake = Arrays.copyOf(awake, Math.max(word + 1, 2 * awake.length));
    }
    if (value) {
      awake[word] |= 1L << slot;
    } else {
      awake[word] &= ~(1L << slot);
    }
  }

  /** Returns the first awake joint from a slot on, -1 if there is none. */
  public int nextAwake(int from) {
    int word = from >> 6;
    if (word >= awake.length) {
      return -1;
    }
    long bits = awake[word] & -1L << from;
    while (bits == 0) {
      if (++word == awake.length) {
        return -1;
      }
      bits = awake[word];
    }
    return (word << 6) + Long.numberOfTrailingZeros(bits);
  }

  /** Puts all joints to sleep. */
  public void clearAwake() {
    version++;
    Arrays.fill(awake, 0);
  }

  /** Returns whether no joint keeps two bodies from colliding. */
  public boolean mayTouch(int a, int b) {
    if (count() == 0) {
      return true;
    }
    for (int end = firstEnd(a); end >= 0; end = lists.next(end)) {
      int j = end >> 1;
      int other = (end & 1) == 0 ? bodyB[j] : bodyA[j];
      if (other == b && (flags[j] & COLLIDE) == 0) {
        return false;
      }
    }
    return true;
  }

  /** Returns whether full turns of a joint are counted. */
  public boolean winds(int slot) {
    return (flags[slot] & WINDS) != 0;
  }

  /** Returns whether a joint is a rod: a distance joint that keeps its length, and does no more. */
  public boolean isRod(int slot) {
    return type[slot] == DISTANCE
        && (flags[slot] & (DRIVEN | SPRUNG)) == 0
        && ((flags[slot] & LIMITED) == 0 || lower[slot] == upper[slot]);
  }

  /** Returns whether a joint is a weld without springs. */
  public boolean isRigidWeld(int slot) {
    return type[slot] == WELD && hertz[slot] == 0 && angularHertz[slot] == 0;
  }

  /** Returns the length of a rod, m. */
  public float rodLength(int slot) {
    return (flags[slot] & LIMITED) == 0 ? rest[slot] : lower[slot];
  }

  /** Returns the impulse that a rod exerted in the last substep, N s; pressure is positive. */
  public float rodImpulse(int slot) {
    return impulseX[slot] + lowerImpulse[slot] - upperImpulse[slot];
  }

  /** Sets the impulse that a rod exerted in the last substep, N s; pressure is positive. */
  public void setRodImpulse(int slot, float impulse) {
    boolean limited = (flags[slot] & LIMITED) != 0;
    impulseX[slot] = limited ? 0 : impulse;
    lowerImpulse[slot] = limited ? Math.max(impulse, 0) : 0;
    upperImpulse[slot] = limited ? Math.max(-impulse, 0) : 0;
  }

  /** Returns whether a joint turns in one direction only. */
  public boolean isRatchet(int slot) {
    return type[slot] == REVOLUTE && ratio[slot] != 0;
  }

  /** Returns the angle of the last tooth that a ratchet has passed, rad. */
  public double tooth(int slot) {
    return (double) ratio[slot] * turnsA[slot];
  }

  /** Counts the teeth that a ratchet has passed at an angle over all turns, rad. */
  public void passTeeth(int slot, double angle) {
    double passed = Math.floor(angle / ratio[slot]);
    if (passed > turnsA[slot]) {
      turnsA[slot] = (int) passed;
    }
  }

  /** Counts full turns of A, and returns its angle over all of them, rad. */
  public double windA(int slot, float angle) {
    turnsA[slot] += turn(lastA[slot], angle);
    lastA[slot] = angle;
    return angle + TWO_PI * turnsA[slot];
  }

  /** Counts full turns of B, and returns its angle over all of them, rad. */
  public double windB(int slot, float angle) {
    turnsB[slot] += turn(lastB[slot], angle);
    lastB[slot] = angle;
    return angle + TWO_PI * turnsB[slot];
  }

  /**
   * Returns the angle of A over all turns, rad, without counting.
   *
   * @param slot of a joint that counts turns
   * @param angle rad, -pi to pi
   */
  public double woundA(int slot, float angle) {
    return angle + TWO_PI * (turnsA[slot] + turn(lastA[slot], angle));
  }

  /**
   * Returns the angle of B, or of B relative to A, over all turns, rad, without counting.
   *
   * @param slot of a joint that counts turns
   * @param angle rad, -pi to pi
   */
  public double woundB(int slot, float angle) {
    return angle + TWO_PI * (turnsB[slot] + turn(lastB[slot], angle));
  }

  /**
   * Returns the full turns between two angles. Bodies turn less than half a turn between two looks,
   * so a larger jump is the seam at pi.
   */
  private static int turn(float before, float now) {
    double way = (double) now - before;
    return way > Math.PI ? -1 : way < -Math.PI ? 1 : 0;
  }

  /** Returns whether any joint breaks under some force or torque. */
  public boolean anyBreakable() {
    for (int j = 0; j < slots(); j++) {
      if (type[j] != FREE
          && (breakForce[j] < Float.POSITIVE_INFINITY
              || breakTorque[j] < Float.POSITIVE_INFINITY)) {
        return true;
      }
    }
    return false;
  }

  /** Forgets the impulses of a joint, which then starts cold. */
  public void forget(int slot) {
    impulseX[slot] = 0;
    impulseY[slot] = 0;
    impulseW[slot] = 0;
    springImpulse[slot] = 0;
    motorImpulse[slot] = 0;
    lowerImpulse[slot] = 0;
    upperImpulse[slot] = 0;
    forceX[slot] = 0;
    forceY[slot] = 0;
    torque[slot] = 0;
  }

  /** Returns whether a joint is a hinge without limits, motor and spring. */
  public boolean isPlainHinge(int slot) {
    return type[slot] == REVOLUTE
        && (flags[slot] & (LIMITED | DRIVEN | SPRUNG)) == 0
        && !isRatchet(slot);
  }

  /** Returns whether a joint couples two coordinates: a gear, rack or pulley. */
  public boolean isCoupled(int slot) {
    return type[slot] == GEAR || type[slot] == RACK || type[slot] == PULLEY;
  }

  /** Returns whether a joint holds bodies rigidly and does no more: a hinge, weld or rod. */
  public boolean isRigid(int slot) {
    return isPlainHinge(slot) || isRigidWeld(slot) || isRod(slot);
  }

  /** Returns whether a joint acts by itself, by a motor, a brake or a spring. */
  public boolean isActive(int slot) {
    return (flags[slot] & DRIVEN) != 0 || hasSpring(slot);
  }

  /** Returns whether a joint has a spring. */
  public boolean hasSpring(int slot) {
    return (flags[slot] & SPRUNG) != 0 || hertz[slot] > 0 || angularHertz[slot] > 0;
  }

  /** Scales the impulses with which a joint starts its next substep. */
  public void scaleImpulses(int slot, float share) {
    impulseX[slot] *= share;
    impulseY[slot] *= share;
    impulseW[slot] *= share;
    springImpulse[slot] *= share;
    motorImpulse[slot] *= share;
    lowerImpulse[slot] *= share;
    upperImpulse[slot] *= share;
  }

  /** Mixes all that influences the future into a hash; nothing if there never was a joint. */
  public long hash(long h) {
    if (slots() == 0) {
      return h;
    }
    if (!cold.same(hashed)) {
      coldHash = hashCold();
      cold.copyTo(hashed);
    }
    h = StateHash.mix(h, coldHash);
    for (int f = HOT; f < floats.length; f++) {
      h = columns.mix(h, floats[f], slots());
    }
    for (int j = 0; j < slots(); j++) {
      if (winds(j)) {
        h = StateHash.mix(h, (long) turnsA[j] << 32 | turnsB[j] & 0xffffffffL);
        h = StateHash.mix(h, lastA[j], lastB[j]);
      }
    }
    return h;
  }

  /** Returns the hash of what no step changes. */
  private long hashCold() {
    long h = slots.hash();
    for (int i = 0; i < slots(); i++) {
      long kind = (long) flags[i] << 8 | type[i] & 0xff;
      h = StateHash.mix(h, (long) slots.generation(i) << 16 | kind);
      if (type[i] == FREE) {
        continue;
      }
      h = StateHash.mix(h, (long) bodyA[i] << 32 | bodyB[i]);
      for (int f = 0; f < HOT; f++) {
        h = StateHash.mix(h, floats[f][i], 0);
      }
      if (ratio[i] != 0) {
        h = StateHash.mix(h, ratio[i], 0);
        h = StateHash.mix(h, baseAx[i], baseAy[i]);
        h = StateHash.mix(h, baseBx[i], baseBy[i]);
      }
    }
    return lists.hash(h);
  }

  /**
   * Copies everything into another store, which grows as needed; allocates only then.
   *
   * @return the bytes that were copied
   */
  public long copyTo(JointStore to) {
    while (to.type.length < slots()) {
      to.grow();
    }
    for (int f = HOT; f < floats.length; f++) {
      System.arraycopy(floats[f], 0, to.floats[f], 0, slots());
    }
    System.arraycopy(turnsA, 0, to.turnsA, 0, slots());
    System.arraycopy(turnsB, 0, to.turnsB, 0, slots());
    System.arraycopy(lastA, 0, to.lastA, 0, slots());
    System.arraycopy(lastB, 0, to.lastB, 0, slots());
    long bytes = (long) slots() * Float.BYTES * (floats.length - HOT + 4);
    return cold.same(to.cold) ? bytes : bytes + copyColdTo(to);
  }

  private long copyColdTo(JointStore to) {
    System.arraycopy(type, 0, to.type, 0, slots());
    System.arraycopy(flags, 0, to.flags, 0, slots());
    System.arraycopy(bodyA, 0, to.bodyA, 0, slots());
    System.arraycopy(bodyB, 0, to.bodyB, 0, slots());
    System.arraycopy(ratio, 0, to.ratio, 0, slots());
    System.arraycopy(baseAx, 0, to.baseAx, 0, slots());
    System.arraycopy(baseAy, 0, to.baseAy, 0, slots());
    System.arraycopy(baseBx, 0, to.baseBx, 0, slots());
    System.arraycopy(baseBy, 0, to.baseBy, 0, slots());
    for (int f = 0; f < HOT; f++) {
      System.arraycopy(floats[f], 0, to.floats[f], 0, slots());
    }
    long bytes = slots.copyTo(to.slots) + lists.copyTo(to.lists, slots());
    cold.copyTo(to.cold);
    to.version++;
    int perSlot = 2 + 2 * Integer.BYTES + Float.BYTES * (HOT + 5);
    return bytes + (long) slots() * perSlot;
  }

  /** Passes all joints through an archive; reading begins with an empty store. */
  public void pass(Archive a, BodyStore bodies) {
    new JointArchive(this, a, bodies).pass();
    if (a.reads()) {
      coldChanged();
    }
  }

  /** Makes a copy that was read differ from all that were copied from this. */
  public void distinguish(JointStore copy) {
    cold.distinguish(copy.cold);
  }

  void grow() {
    int capacity = type.length * 2;
    type = Arrays.copyOf(type, capacity);
    flags = Arrays.copyOf(flags, capacity);
    bodyA = Arrays.copyOf(bodyA, capacity);
    bodyB = Arrays.copyOf(bodyB, capacity);
    lists.reserve(capacity);
    anchorAx = Arrays.copyOf(anchorAx, capacity);
    anchorAy = Arrays.copyOf(anchorAy, capacity);
    anchorBx = Arrays.copyOf(anchorBx, capacity);
    anchorBy = Arrays.copyOf(anchorBy, capacity);
    axisX = Arrays.copyOf(axisX, capacity);
    axisY = Arrays.copyOf(axisY, capacity);
    refCos = Arrays.copyOf(refCos, capacity);
    refSin = Arrays.copyOf(refSin, capacity);
    rest = Arrays.copyOf(rest, capacity);
    lower = Arrays.copyOf(lower, capacity);
    upper = Arrays.copyOf(upper, capacity);
    motorSpeed = Arrays.copyOf(motorSpeed, capacity);
    motorMax = Arrays.copyOf(motorMax, capacity);
    hertz = Arrays.copyOf(hertz, capacity);
    damping = Arrays.copyOf(damping, capacity);
    angularHertz = Arrays.copyOf(angularHertz, capacity);
    angularDamping = Arrays.copyOf(angularDamping, capacity);
    maxForce = Arrays.copyOf(maxForce, capacity);
    maxTorque = Arrays.copyOf(maxTorque, capacity);
    breakForce = Arrays.copyOf(breakForce, capacity);
    breakTorque = Arrays.copyOf(breakTorque, capacity);
    impulseX = Arrays.copyOf(impulseX, capacity);
    impulseY = Arrays.copyOf(impulseY, capacity);
    impulseW = Arrays.copyOf(impulseW, capacity);
    springImpulse = Arrays.copyOf(springImpulse, capacity);
    motorImpulse = Arrays.copyOf(motorImpulse, capacity);
    lowerImpulse = Arrays.copyOf(lowerImpulse, capacity);
    upperImpulse = Arrays.copyOf(upperImpulse, capacity);
    forceX = Arrays.copyOf(forceX, capacity);
    forceY = Arrays.copyOf(forceY, capacity);
    torque = Arrays.copyOf(torque, capacity);
    ratio = Arrays.copyOf(ratio, capacity);
    baseAx = Arrays.copyOf(baseAx, capacity);
    baseAy = Arrays.copyOf(baseAy, capacity);
    baseBx = Arrays.copyOf(baseBx, capacity);
    baseBy = Arrays.copyOf(baseBy, capacity);
    turnsA = Arrays.copyOf(turnsA, capacity);
    lastA = Arrays.copyOf(lastA, capacity);
    turnsB = Arrays.copyOf(turnsB, capacity);
    lastB = Arrays.copyOf(lastB, capacity);
    floats = gather();
  }

  /** Returns all float arrays for copying and clearing, the cold ones first. */
  private float[][] gather() {
    return new float[][] {
      anchorAx,
      anchorAy,
      anchorBx,
      anchorBy,
      axisX,
      axisY,
      refCos,
      refSin,
      rest,
      lower,
      upper,
      motorSpeed,
      motorMax,
      hertz,
      damping,
      angularHertz,
      angularDamping,
      maxForce,
      maxTorque,
      breakForce,
      breakTorque,
      impulseX,
      impulseY,
      impulseW,
      springImpulse,
      motorImpulse,
      lowerImpulse,
      upperImpulse,
      forceX,
      forceY,
      torque
    };
  }
}
