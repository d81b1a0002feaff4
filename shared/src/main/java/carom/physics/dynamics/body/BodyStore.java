package carom.physics.dynamics.body;

import carom.physics.archive.Archive;
import carom.physics.dynamics.store.ColumnHash;
import carom.physics.dynamics.store.IntList;
import carom.physics.dynamics.store.Slots;
import carom.physics.dynamics.store.Stamp;
import carom.physics.math.Limits;
import carom.physics.math.StateHash;
import java.util.Arrays;

/**
 * All bodies of a world as a structure of arrays; the index is the body's slot.
 *
 * <p>A slot's pose is that of its centre of mass: {@code (x, y)} in world axes, rotation as the
 * unit complex {@code (cos, sin)}. A body's shapes are stored relative to that centre, so that
 * lever arms are small and exact however far from the origin the body is. The body's origin, which
 * users see, is {@code centre - rotation * local centre}.
 *
 * <p>Slots are reused last in, first out; each reuse has another generation. The free list is part
 * of the state, so that a restored world gives out the same slots again.
 *
 * <p><b>Hot</b> numbers may change in every step. They are copied whenever the state is. All others
 * are <b>cold</b> and only copied if one of them changed; code that writes one calls {@link
 * #coldChanged} in the same method.
 *
 * <p>The arrays are public, because kernels read them by the thousand, and are replaced when the
 * store grows: no stage keeps one for the next. All stages read them. Who writes what, and when:
 *
 * <pre>
 *   arrays                          kind   written in a step by       between steps by
 *   x y cos sin                     hot    solver (FINISH),           setCenterPose, setOriginPose,
 *                                          continuous collision       BodyMaker, RowTransfer
 *   vx vy w                         hot    applyImpulses (BEGIN),     Body, RowTransfer
 *                                          solver (FINISH), sleep
 *   force* torque impulse*          hot    useForces, applyImpulses   Body, effects, RowTransfer
 *   flags                           hot    sleep (ASLEEP)             BodyEditor, Body
 *   sleepTime                       hot    sleep                      sleep, RowTransfer
 *   type firstPart partCount        cold   nobody                     allocate, release, BodyEditor
 *   mass inertia local* reach ...   cold   nobody                     BodyMaker
 *   damping gravityScale sleepSpeed cold   nobody                     Body
 * </pre>
 *
 * <p>In a step, workers write different slots side by side; that is why methods below that find
 * nothing to do write nothing.
 */
public final class BodyStore {
  /** Type of a free slot. */
  public static final byte FREE = -1;

  /** Never moves. */
  public static final byte STATIC = 0;

  /** Moves with its velocity, pushed by nothing. */
  public static final byte KINEMATIC = 1;

  /** Moves by forces and contacts. */
  public static final byte DYNAMIC = 2;

  /** Bits of a body's slot; a contact's key holds two slots and two parts in 62 bits. */
  public static final int SLOT_BITS = 21;

  /** Bits of a part's number within its body. */
  public static final int PART_BITS = 10;

  /** The most bodies a world can hold. */
  public static final int MAX_BODIES = 1 << SLOT_BITS;

  /** The most parts a body can have. */
  public static final int MAX_PARTS = 1 << PART_BITS;

  /** Flag: nothing but {@code setAngularVelocity} turns the body. */
  public static final byte FIXED_ROTATION = 1;

  /** Flag: the body is taken out of the simulation. */
  public static final byte DISABLED = 2;

  /** Flag: the body sleeps; it is at rest, and no step looks at it. */
  public static final byte ASLEEP = 4;

  /** Flag: the body may not fall asleep. */
  public static final byte SLEEPLESS = 8;

  /** Flag: while fast, the body is stopped at dynamic bodies, too. */
  public static final byte BULLET = 16;

  /** Flag: nothing but {@code setVelocity} moves the body along x. */
  public static final byte LOCK_X = 32;

  /** Flag: nothing but {@code setVelocity} moves the body along y. */
  public static final byte LOCK_Y = 64;

  /** Value of {@link #sleepSpeed} that stands for the world's. */
  public static final float WORLDS = -1;

  /** The flags of locked axes of the velocity. */
  public static final byte LINEAR_LOCKS = LOCK_X | LOCK_Y;

  private static final byte ALL_FLAGS =
      FIXED_ROTATION | DISABLED | ASLEEP | SLEEPLESS | BULLET | LINEAR_LOCKS;

  private static final int FIRST_CAPACITY = 64;

  /** Number of float arrays that are hot; they come first. */
  private static final int HOT = 13;

  /** Largest number that an archive accepts; a world with larger ones has blown up. */
  public static final float MOST = 1e30f;

  private static final int HOT_BYTES = Float.BYTES * (HOT + 1) + 1;

  /** {@link #FREE}, {@link #STATIC}, {@link #KINEMATIC} or {@link #DYNAMIC}. */
  public byte[] type = new byte[FIRST_CAPACITY];

  /** The flags of the body, added up. */
  public byte[] flags = new byte[FIRST_CAPACITY];

  /** First of the body's shape parts in {@link ShapeTable}; the others follow it. */
  public int[] firstPart = new int[FIRST_CAPACITY];

  /** Number of shape parts. */
  public int[] partCount = new int[FIRST_CAPACITY];

  /** Hash of the body's shapes and materials; goes into the state hash in their place. */
  public long[] shapeHash = new long[FIRST_CAPACITY];

  /** Centre of mass, m. */
  public float[] x = new float[FIRST_CAPACITY];

  /** Centre of mass, m. */
  public float[] y = new float[FIRST_CAPACITY];

  /** Rotation, real part. */
  public float[] cos = new float[FIRST_CAPACITY];

  /** Rotation, imaginary part. */
  public float[] sin = new float[FIRST_CAPACITY];

  /** Velocity of the centre of mass, m/s. */
  public float[] vx = new float[FIRST_CAPACITY];

  /** Velocity of the centre of mass, m/s. */
  public float[] vy = new float[FIRST_CAPACITY];

  /** Angular velocity, rad/s. */
  public float[] w = new float[FIRST_CAPACITY];

  /** Force that acts during the next step, N. */
  public float[] forceX = new float[FIRST_CAPACITY];

  /** Force that acts during the next step, N. */
  public float[] forceY = new float[FIRST_CAPACITY];

  /** Torque that acts during the next step, N m. */
  public float[] torque = new float[FIRST_CAPACITY];

  /** Impulse that acts at the start of the next step, N s. */
  public float[] impulseX = new float[FIRST_CAPACITY];

  /** Impulse that acts at the start of the next step, N s. */
  public float[] impulseY = new float[FIRST_CAPACITY];

  /** Angular impulse that acts at the start of the next step, N m s. */
  public float[] impulseW = new float[FIRST_CAPACITY];

  /** One over the mass, 1/kg; 0 if not dynamic. */
  public float[] invMass = new float[FIRST_CAPACITY];

  /** One over the moment of inertia about the centre, 1/(kg m^2); 0 if rotation is fixed. */
  public float[] invInertia = new float[FIRST_CAPACITY];

  /** Mass, kg; 0 if not dynamic. */
  public float[] mass = new float[FIRST_CAPACITY];

  /** Moment of inertia about the centre, kg m^2; 0 if not dynamic or rotation is fixed. */
  public float[] inertia = new float[FIRST_CAPACITY];

  /** Centre of mass in the body frame, m. */
  public float[] localX = new float[FIRST_CAPACITY];

  /** Centre of mass in the body frame, m. */
  public float[] localY = new float[FIRST_CAPACITY];

  /** Rate at which velocity decays, 1/s. */
  public float[] linearDamping = new float[FIRST_CAPACITY];

  /** Rate at which angular velocity decays, 1/s. */
  public float[] angularDamping = new float[FIRST_CAPACITY];

  /** Factor on the world's gravity. */
  public float[] gravityScale = new float[FIRST_CAPACITY];

  /** Speed below which the body is at rest, m/s; {@link #WORLDS} for the world's. */
  public float[] sleepSpeed = new float[FIRST_CAPACITY];

  /** Inner radius of the thinnest part that isn't a sensor, m; infinite without any. */
  public float[] innerRadius = new float[FIRST_CAPACITY];

  /** Time for which the body has been at rest, s, up to the world's sleep delay. */
  public float[] sleepTime = new float[FIRST_CAPACITY];

  /** Distance from the centre of mass that no point of the body exceeds, m. */
  public float[] reach = new float[FIRST_CAPACITY];

  /** True once a body had a locked axis. Until then, no stage looks for locks. */
  private boolean locks;

  private float[][] floats = gather();

  private final Slots slots = new Slots();
  private final Stamp cold = new Stamp();

  /** The hash of the cold numbers, as of {@link #hashed}. */
  private long coldHash = hashCold();

  private final Stamp hashed = new Stamp();
  private final ColumnHash columns = new ColumnHash();

  /** Makes an empty store. */
  public BodyStore() {}

  /**
   * Returns the number of bodies.
   *
   * @return slots in use
   */
  public int count() {
    return slots.count();
  }

  /**
   * Returns one more than the largest slot ever used.
   *
   * @return the bound of loops over all slots, free ones included
   */
  public int slots() {
    return slots.bound();
  }

  /** Gives free slots out in ascending order from now on, until bodies are destroyed. */
  public void sortFree() {
    slots.sortFree();
  }

  /**
   * Returns how often a slot was given back, for handles.
   *
   * @param slot below {@link #slots}
   * @return what {@link #alive} expects of a handle made now
   */
  public int generation(int slot) {
    return slots.generation(slot);
  }

  /**
   * Takes a slot; all numbers are zero, rotation is none, gravity scale is one.
   *
   * @param newType {@link #STATIC}, {@link #KINEMATIC} or {@link #DYNAMIC}
   * @return the slot
   * @throws IllegalStateException if the world is full
   */
  public int allocate(byte newType) {
    if (slots.count() == MAX_BODIES) {
      throw new IllegalStateException(
          "bodies="
              + MAX_BODIES
              + " is the most a world can hold; destroy some or use more worlds");
    }
    int slot = slots.take();
    if (slot == type.length) {
      grow();
    }
    for (int f = HOT; f < floats.length; f++) {
      floats[f][slot] = 0;
    }
    rest(slot);
    gravityScale[slot] = 1;
    sleepSpeed[slot] = WORLDS;
    type[slot] = newType;
    firstPart[slot] = 0;
    partCount[slot] = 0;
    reach[slot] = 0;
    shapeHash[slot] = 0;
    coldChanged();
    return slot;
  }

  /**
   * Gives a slot back; handles of its generation become invalid.
   *
   * @param slot a slot in use
   */
  public void release(int slot) {
    type[slot] = FREE;
    rest(slot);
    slots.release(slot);
    coldChanged();
  }

  /** Sets what is hot to what free slots hold, so that it is the same in equal states. */
  private void rest(int slot) {
    for (int f = 0; f < HOT; f++) {
      floats[f][slot] = 0;
    }
    cos[slot] = 1;
    flags[slot] = 0;
    sleepTime[slot] = 0;
  }

  /** Notes that a cold number was written, so that copies and hashes take it over. */
  public void coldChanged() {
    cold.change();
  }

  /** Replaces a list by all parts of some bodies. */
  public void listParts(int[] which, int n, IntList to) {
    to.count = 0;
    for (int i = 0; i < n; i++) {
      int first = firstPart[which[i]];
      int end = first + partCount[which[i]];
      for (int part = first; part < end; part++) {
        to.add(part);
      }
    }
  }

  /**
   * Returns whether this is the body of that handle, still alive.
   *
   * @param slot any slot a handle holds
   * @param expected the handle's generation
   * @return false if the body was destroyed
   */
  public boolean alive(int slot, int expected) {
    return slot < slots.bound() && slots.generation(slot) == expected && type[slot] != FREE;
  }

  /**
   * Returns whether a body is taken out of the simulation.
   *
   * @param slot a slot in use
   * @return true if it neither moves nor collides
   */
  public boolean disabled(int slot) {
    return (flags[slot] & DISABLED) != 0;
  }

  /**
   * Returns whether a body sleeps.
   *
   * @param slot a slot in use
   * @return true if no step looks at it
   */
  public boolean asleep(int slot) {
    return (flags[slot] & ASLEEP) != 0;
  }

  /** Returns whether steps look at a body. */
  public boolean active(int slot) {
    return type[slot] != STATIC && !asleep(slot) && !disabled(slot);
  }

  /**
   * Returns whether a body is a bullet.
   *
   * @param slot a slot in use
   * @return true if it is stopped at dynamic bodies, too
   */
  public boolean bullet(int slot) {
    return (flags[slot] & BULLET) != 0;
  }

  /**
   * Makes a body a bullet, or an ordinary body.
   *
   * @param slot a slot in use
   * @param bullet whether it is stopped at dynamic bodies, too
   */
  public void setBullet(int slot, boolean bullet) {
    flags[slot] = (byte) (bullet ? flags[slot] | BULLET : flags[slot] & ~BULLET);
  }

  /** Returns whether any body's velocity has a locked axis, or had one. */
  public boolean anyLinearLocks() {
    return locks;
  }

  /**
   * Returns which axes of a body's velocity are locked.
   *
   * @param slot a slot in use
   * @return {@link #LOCK_X} and {@link #LOCK_Y}, added up; 0 unless the body is dynamic
   */
  public int linearLocks(int slot) {
    return type[slot] == DYNAMIC ? flags[slot] & LINEAR_LOCKS : 0;
  }

  /** Returns whether one of two bodies is locked along an axis; -1 stands for none. */
  public boolean areLocked(int a, int b) {
    return locks && ((a >= 0 && linearLocks(a) != 0) || (b >= 0 && linearLocks(b) != 0));
  }

  /** Returns whether a body is locked along an axis, along which it moves. */
  public boolean isLockedMotion(int slot) {
    int axes = locks ? linearLocks(slot) : 0;
    return ((axes & LOCK_X) != 0 && vx[slot] != 0) || ((axes & LOCK_Y) != 0 && vy[slot] != 0);
  }

  /**
   * Sets which axes of a body's velocity are locked.
   *
   * @param slot a slot in use
   * @param axes {@link #LOCK_X} and {@link #LOCK_Y}, added up
   */
  public void setLinearLocks(int slot, int axes) {
    flags[slot] = (byte) (flags[slot] & ~LINEAR_LOCKS | axes);
    locks |= axes != 0;
  }

  /**
   * Sets pose by the centre of mass, bit for bit.
   *
   * @param slot which
   * @param newX centre, m
   * @param newY centre, m
   * @param c cosine; (c, s) is normalised unless its length is 1 up to rounding
   * @param s sine
   */
  public void setCenterPose(int slot, float newX, float newY, float c, float s) {
    checkPose(newX, newY, c, s);
    setRotation(slot, c, s);
    x[slot] = newX;
    y[slot] = newY;
  }

  /**
   * Sets pose by the body's origin.
   *
   * @param slot which
   * @param originX body origin, m
   * @param originY body origin, m
   * @param c cosine; (c, s) is normalised unless its length is 1 up to rounding
   * @param s sine
   */
  public void setOriginPose(int slot, float originX, float originY, float c, float s) {
    checkPose(originX, originY, c, s);
    setRotation(slot, c, s);
    x[slot] = originX + (cos[slot] * localX[slot] - sin[slot] * localY[slot]);
    y[slot] = originY + (sin[slot] * localX[slot] + cos[slot] * localY[slot]);
  }

  /**
   * Returns a coordinate of the body's origin.
   *
   * @param slot which
   * @return x, m
   */
  public float originX(int slot) {
    return x[slot] - (cos[slot] * localX[slot] - sin[slot] * localY[slot]);
  }

  /**
   * Returns a coordinate of the body's origin.
   *
   * @param slot which
   * @return y, m
   */
  public float originY(int slot) {
    return y[slot] - (sin[slot] * localX[slot] + cos[slot] * localY[slot]);
  }

  /** Returns whether a body is at the same pose in another store, bit for bit. */
  public boolean samePose(BodyStore other, int slot) {
    return x[slot] == other.x[slot]
        && y[slot] == other.y[slot]
        && cos[slot] == other.cos[slot]
        && sin[slot] == other.sin[slot];
  }

  /** Refuses a pose that no body may be given. */
  public static void checkPose(float x, float y, float c, float s) {
    Limits.position("x", x);
    Limits.position("y", y);
    float lengthSquared = c * c + s * s;
    if (!(lengthSquared >= 1e-6f && lengthSquared <= 1e6f)) {
      throw new IllegalArgumentException(
          "cos=" + c + " sin=" + s + " is not a rotation; their squares should add up to 1");
    }
  }

  private void setRotation(int slot, float c, float s) {
    float lengthSquared = c * c + s * s;
    if (Math.abs(lengthSquared - 1) > 1e-6f) {
      float length = (float) Math.sqrt(lengthSquared);
      c /= length;
      s /= length;
    }
    cos[slot] = c;
    sin[slot] = s;
  }

  /**
   * Adds pending impulses to the velocity and clears them. Writes nothing if there are none,
   * because the neighbouring slots may be another thread's.
   */
  public void applyImpulses(int slot) {
    if (impulseX[slot] == 0 && impulseY[slot] == 0 && impulseW[slot] == 0) {
      return;
    }
    if ((flags[slot] & LOCK_X) == 0) {
      vx[slot] += invMass[slot] * impulseX[slot];
    }
    if ((flags[slot] & LOCK_Y) == 0) {
      vy[slot] += invMass[slot] * impulseY[slot];
    }
    w[slot] += invInertia[slot] * impulseW[slot];
    impulseX[slot] = 0;
    impulseY[slot] = 0;
    impulseW[slot] = 0;
  }

  /** Clears the forces of a step; writes nothing if there are none. */
  public void useForces(int slot) {
    if (forceX[slot] != 0 || forceY[slot] != 0 || torque[slot] != 0) {
      forceX[slot] = 0;
      forceY[slot] = 0;
      torque[slot] = 0;
    }
  }

  /** Returns whether a force or an impulse is pending. */
  public boolean pushed(int slot) {
    return forceX[slot] != 0
        || forceY[slot] != 0
        || torque[slot] != 0
        || impulseX[slot] != 0
        || impulseY[slot] != 0
        || impulseW[slot] != 0;
  }

  /** Clears all pending forces and impulses. */
  public void clearForces(int slot) {
    forceX[slot] = 0;
    forceY[slot] = 0;
    torque[slot] = 0;
    impulseX[slot] = 0;
    impulseY[slot] = 0;
    impulseW[slot] = 0;
  }

  /** Adds everything that influences the future to a hash. */
  public long hash(long h) {
    if (!cold.same(hashed)) {
      coldHash = hashCold();
      cold.copyTo(hashed);
    }
    h = columns.mix(StateHash.mix(h, coldHash), flags, slots());
    for (int f = 0; f < HOT; f++) {
      h = columns.mix(h, floats[f], slots());
    }
    return columns.mix(h, sleepTime, slots());
  }

  /** Returns a hash of the cold numbers. */
  private long hashCold() {
    long h = slots.hash();
    for (int i = 0; i < slots(); i++) {
      h = StateHash.mix(h, (long) slots.generation(i) << 8 | type[i] & 0xff);
      if (type[i] != FREE) {
        h = StateHash.mix(h, shapeHash[i]);
        h = StateHash.mix(h, invMass[i], invInertia[i]);
        h = StateHash.mix(h, mass[i], inertia[i]);
        h = StateHash.mix(h, localX[i], localY[i]);
        h = StateHash.mix(h, linearDamping[i], angularDamping[i]);
        h = StateHash.mix(h, gravityScale[i], innerRadius[i]);
        if (sleepSpeed[i] != WORLDS) {
          h = StateHash.mix(h, sleepSpeed[i], 1);
        }
      }
    }
    return h;
  }

  /**
   * Copies everything into another store, which grows as needed; allocates only then.
   *
   * @return the bytes that were copied
   */
  public long copyTo(BodyStore to) {
    while (to.type.length < slots()) {
      to.grow();
    }
    System.arraycopy(flags, 0, to.flags, 0, slots());
    System.arraycopy(sleepTime, 0, to.sleepTime, 0, slots());
    for (int f = 0; f < HOT; f++) {
      System.arraycopy(floats[f], 0, to.floats[f], 0, slots());
    }
    to.locks |= locks;
    long bytes = (long) slots() * HOT_BYTES;
    return cold.same(to.cold) ? bytes : bytes + copyColdTo(to);
  }

  private long copyColdTo(BodyStore to) {
    System.arraycopy(type, 0, to.type, 0, slots());
    System.arraycopy(firstPart, 0, to.firstPart, 0, slots());
    System.arraycopy(partCount, 0, to.partCount, 0, slots());
    System.arraycopy(shapeHash, 0, to.shapeHash, 0, slots());
    System.arraycopy(reach, 0, to.reach, 0, slots());
    for (int f = HOT; f < floats.length; f++) {
      System.arraycopy(floats[f], 0, to.floats[f], 0, slots());
    }
    long bytes = slots.copyTo(to.slots);
    cold.copyTo(to.cold);
    int perSlot = 1 + 3 * Integer.BYTES + Long.BYTES + Float.BYTES * (floats.length - HOT);
    return bytes + (long) slots() * perSlot;
  }

  /**
   * Passes slots through an archive: which are in use, by what, and in which order free ones will
   * be given out. What they hold follows by {@link #passMotion}.
   */
  public void passSlots(Archive a) {
    int n = a.count("body slots", slots(), MAX_BODIES, 2 + Integer.BYTES);
    while (type.length < n) {
      grow();
    }
    a.bytes("type of body", type, n, FREE, DYNAMIC);
    a.bytes("flags of body", flags, n, 0, ALL_FLAGS);
    slots.passGenerations(a, "body", n);
    slots.passFree(a, "body", n, type, FREE);
    if (a.reads()) {
      checkSlots(a);
      coldChanged();
    }
  }

  /** Makes a copy that was read differ from all that were copied from this. */
  public void distinguish(BodyStore copy) {
    cold.distinguish(copy.cold);
  }

  private void checkSlots(Archive a) {
    for (int slot = 0; slot < slots(); slot++) {
      locks |= (flags[slot] & LINEAR_LOCKS) != 0;
      boolean sleeps = asleep(slot) && type[slot] != FREE;
      a.require(
          !sleeps || (type[slot] != STATIC && !disabled(slot)), "body=" + slot + " can't sleep");
    }
  }

  /** Passes poses, velocities, what acts on bodies, and damping through an archive. */
  public void passMotion(Archive a) {
    a.numbers("x", x, slots(), MOST);
    a.numbers("y", y, slots(), MOST);
    a.numbers("cos", cos, slots(), 2);
    a.numbers("sin", sin, slots(), 2);
    for (int f = 4; f < HOT; f++) {
      a.numbers("velocity or force", floats[f], slots(), MOST);
    }
    a.numbers("time of rest", sleepTime, slots(), MOST);
    a.numbers("linear damping", linearDamping, slots(), Limits.MAX_DAMPING);
    a.numbers("angular damping", angularDamping, slots(), Limits.MAX_DAMPING);
    a.numbers("gravity scale", gravityScale, slots(), Limits.MAX_GRAVITY_SCALE);
    a.numbers("sleep speed", sleepSpeed, slots(), Limits.MAX_SLEEP_SPEED);
    for (int slot = 0; a.reads() && slot < slots(); slot++) {
      if (type[slot] == FREE) {
        rest(slot);
      }
      float square = cos[slot] * cos[slot] + sin[slot] * sin[slot];
      a.require(
          type[slot] == FREE || Math.abs(square - 1) < 0.01f,
          "cos^2+sin^2=" + square + " of body=" + slot + " is no rotation");
      a.require(
          type[slot] == FREE || (linearDamping[slot] >= 0 && angularDamping[slot] >= 0),
          "damping of body=" + slot + " is negative");
      a.require(
          type[slot] == FREE || sleepSpeed[slot] >= 0 || sleepSpeed[slot] == WORLDS,
          "sleep speed of body=" + slot + " is negative");
    }
  }

  private void grow() {
    int capacity = type.length * 2;
    type = Arrays.copyOf(type, capacity);
    flags = Arrays.copyOf(flags, capacity);
    firstPart = Arrays.copyOf(firstPart, capacity);
    partCount = Arrays.copyOf(partCount, capacity);
    shapeHash = Arrays.copyOf(shapeHash, capacity);
    x = Arrays.copyOf(x, capacity);
    y = Arrays.copyOf(y, capacity);
    cos = Arrays.copyOf(cos, capacity);
    sin = Arrays.copyOf(sin, capacity);
    vx = Arrays.copyOf(vx, capacity);
    vy = Arrays.copyOf(vy, capacity);
    w = Arrays.copyOf(w, capacity);
    forceX = Arrays.copyOf(forceX, capacity);
    forceY = Arrays.copyOf(forceY, capacity);
    torque = Arrays.copyOf(torque, capacity);
    impulseX = Arrays.copyOf(impulseX, capacity);
    impulseY = Arrays.copyOf(impulseY, capacity);
    impulseW = Arrays.copyOf(impulseW, capacity);
    invMass = Arrays.copyOf(invMass, capacity);
    invInertia = Arrays.copyOf(invInertia, capacity);
    mass = Arrays.copyOf(mass, capacity);
    inertia = Arrays.copyOf(inertia, capacity);
    localX = Arrays.copyOf(localX, capacity);
    localY = Arrays.copyOf(localY, capacity);
    linearDamping = Arrays.copyOf(linearDamping, capacity);
    angularDamping = Arrays.copyOf(angularDamping, capacity);
    gravityScale = Arrays.copyOf(gravityScale, capacity);
    sleepSpeed = Arrays.copyOf(sleepSpeed, capacity);
    innerRadius = Arrays.copyOf(innerRadius, capacity);
    sleepTime = Arrays.copyOf(sleepTime, capacity);
    reach = Arrays.copyOf(reach, capacity);
    floats = gather();
  }

  /** Returns all float arrays, for copying and clearing; the hot ones first. */
  private float[][] gather() {
    return new float[][] {
      x,
      y,
      cos,
      sin,
      vx,
      vy,
      w,
      forceX,
      forceY,
      torque,
      impulseX,
      impulseY,
      impulseW,
      invMass,
      invInertia,
      mass,
      inertia,
      localX,
      localY,
      linearDamping,
      angularDamping,
      gravityScale,
      sleepSpeed,
      innerRadius
    };
  }
}
