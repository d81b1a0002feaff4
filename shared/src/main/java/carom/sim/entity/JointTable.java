package carom.sim.entity;

import carom.physics.Body;
import carom.physics.Joint;
import carom.physics.JointType;
import carom.physics.World;
import carom.physics.archive.Archive;
import carom.physics.math.StateHash;
import carom.physics.math.Transform;
import carom.physics.rows.JointDefRow;
import carom.sim.level.Level;
import carom.sim.level.LevelJoint;
import java.util.Arrays;

/**
 * The simulation's knowledge of its joints beyond the physics: under which key the server knows
 * each, what it was made with, and which joint of which assembly it is.
 *
 * <p>A joint's <em>key</em> is the same on server and clients: the joint's index in the server's
 * world and its generation, {@code index | generation << 16}. So the order of keys is the order in
 * which the server solves joints. A client's world has indices of its own.
 *
 * <p>One simulation's; one thread. Allocates only to grow.
 *
 * @param <T> the world's type of users
 */
public final class JointTable<T> {
  /** Most joints of a simulation; indices are 0..65534. */
  public static final int MAX_JOINTS = 65_535;

  /** Root of a joint that belongs to no assembly. */
  public static final int NO_ROOT = -1;

  /** Root of a joint that the level places; its number is its place in the level's list. */
  public static final int LEVEL = -2;

  // Columns of a joint's numbers, in this order.
  private static final int KEY = 0;
  private static final int ROOT = 1;
  private static final int NUMBER = 2;
  private static final int DEFINITION = 3;
  private static final int STRIDE = DEFINITION + JointDefRow.INTS;

  /** A copy of a table at one moment; see {@link #save}. */
  public static final class Saved {
    private long version = -1;
    private int limit;
    private int[] numbers = {};

    /** Creates an empty copy. */
    public Saved() {}

    /**
     * Passes the copy through an archive, in either direction.
     *
     * @param a the archive
     */
    public void pass(Archive a) {
      limit = a.count("joints", limit, MAX_JOINTS, STRIDE * Integer.BYTES);
      numbers = a.reads() ? new int[limit * STRIDE] : numbers;
      int most = Integer.MAX_VALUE;
      a.integers("number of joint", numbers, limit * STRIDE, Integer.MIN_VALUE, most);
      version = a.reads() ? -1 : version;
    }
  }

  private static final Transform HERE = new Transform();

  private final World<T> world;
  private final boolean isAuthority;

  /** By index of a joint in the world: its columns. */
  private int[] numbers = {};

  private long version;
  private long lastVersion;

  /** The definition of a joint that is placed or moved. */
  private final int[] placed = new int[JointDefRow.INTS];

  // What the next joint is, if it was announced.
  private boolean announced;
  private int nextKey;
  private int nextRoot;
  private int nextNumber;
  private int[] nextDefinition;
  private int nextAt;

  /**
   * Creates the table of a world without joints.
   *
   * @param isAuthority whether this world's indices are the keys, and its joints may be made by
   *     anybody
   */
  public JointTable(World<T> world, boolean isAuthority) {
    this.world = world;
    this.isAuthority = isAuthority;
  }

  /** Receives the joints of a level; see {@link #forEachOfLevel}. */
  public interface LevelJointVisitor {
    /**
     * Visits a joint, by ascending indices from 0 on.
     *
     * @param index in the server's world; the generation is 0
     * @param endA as in {@code JointRow}, with the key of an entity for a place
     * @param endB as {@code endA}
     * @param definition what it is made with; must not be changed
     */
    void joint(int index, int endA, int endB, int[] definition);
  }

  /**
   * Visits the joints that a level places, as the server has them at tick 0. So clients know them
   * without a byte on the wire.
   */
  public static void forEachOfLevel(Level level, LevelJointVisitor visitor) {
    for (int i = 0; i < level.joints().size(); i++) {
      LevelJoint joint = level.joints().get(i);
      visitor.joint(i, joint.a(), joint.b(), joint.definition());
    }
  }

  /** Returns the key of a joint. */
  public static int key(int index, int generation) {
    return index | (generation & 0xff) << 16;
  }

  /** Returns the index in a key. */
  public static int index(int key) {
    return key & 0xffff;
  }

  /** Returns the generation in a key, 0..255. */
  public static int generation(int key) {
    return key >>> 16;
  }

  /**
   * Creates a joint of an assembly or of the level, or mirrors one of the server's.
   *
   * @param key ignored on the authority, whose world gives it
   * @param root the assembly it belongs to: the id of its root, {@link #NO_ROOT} or {@link #LEVEL}
   * @param number which joint of it
   * @param a null for the world
   * @param b another body
   * @param definition what it is made with, see {@link World#createJoint(Body, Body, int[], int)}
   * @param at where that begins
   * @throws IllegalArgumentException if the definition is damaged; no joint is made then
   */
  public Joint<T> create(
      int key, int root, int number, Body<T> a, Body<T> b, int[] definition, int at) {
    announced = true;
    nextKey = key;
    nextRoot = root;
    nextNumber = number;
    nextDefinition = definition;
    nextAt = at;
    try {
      return world.createJoint(a, b, definition, at);
    } finally {
      announced = false;
    }
  }

  /**
   * Creates a joint of an assembly that is spawned.
   *
   * @param pose of the assembly's frame
   * @param root the id of the assembly's root
   * @param number which joint of it
   * @param a a body, where it is spawned
   * @param b another body, where it is spawned
   * @param definition what it is made with in the assembly's frame
   * @param at where that begins
   */
  public Joint<T> place(
      Transform pose, int root, int number, Body<T> a, Body<T> b, int[] definition, int at) {
    System.arraycopy(definition, at, placed, 0, JointDefRow.INTS);
    moveBases(a, b, HERE, pose);
    return create(0, root, number, a, b, placed, 0);
  }

  /**
   * Makes the gears and pulleys of an assembly anew after it was moved rigidly. What they refer to
   * moves along: of a gear the rotations from which it counts, of a pulley the points over which
   * its ropes run. Does nothing on a client, which takes the server's new joints over.
   */
  public void assemblyMoved(int root, Transform before, Transform after) {
    for (int i = 0; isAuthority && i < limit(); i++) {
      Joint<T> joint = world.joint(i);
      if (joint != null && root(i) == root && isPlaced(joint.type())) {
        Body<T> a = joint.bodyA();
        Body<T> b = joint.bodyB();
        int number = number(i);
        world.readJoint(joint, placed, 0);
        moveBases(a, b, before, after);
        world.destroyJoint(joint);
        create(0, root, number, a, b, placed, 0);
      }
    }
  }

  /** Returns whether joints of a type refer to more than the frames of their bodies. */
  private static boolean isPlaced(JointType type) {
    return type == JointType.GEAR || type == JointType.PULLEY;
  }

  private void moveBases(Body<T> a, Body<T> b, Transform before, Transform after) {
    int type = placed[JointDefRow.TYPE];
    if (type == JointType.GEAR.ordinal()) {
      setNumbers(JointDefRow.BASE_AX, a.cos(), a.sin());
      setNumbers(JointDefRow.BASE_BX, b.cos(), b.sin());
    } else if (type == JointType.PULLEY.ordinal()) {
      moveBase(JointDefRow.BASE_AX, before, after);
      moveBase(JointDefRow.BASE_BX, before, after);
    }
  }

  private void moveBase(int field, Transform before, Transform after) {
    float x = Float.intBitsToFloat(placed[field]) - before.x;
    float y = Float.intBitsToFloat(placed[field + 1]) - before.y;
    float c = after.cos * before.cos + after.sin * before.sin;
    float s = after.sin * before.cos - after.cos * before.sin;
    setNumbers(field, after.x + c * x - s * y, after.y + s * x + c * y);
  }

  private void setNumbers(int field, float x, float y) {
    placed[field] = Float.floatToRawIntBits(x);
    placed[field + 1] = Float.floatToRawIntBits(y);
  }

  /**
   * Lists a joint that the world has just created.
   *
   * @throws IllegalStateException if there are too many, or if this isn't the authority and the
   *     joint was not announced
   */
  public void created(Joint<T> joint) {
    int at = joint.index() * STRIDE;
    if (joint.index() >= MAX_JOINTS) {
      world.destroyJoint(joint);
      throw new IllegalStateException("joints=" + MAX_JOINTS + " is the limit");
    }
    if (!isAuthority && !announced) {
      world.destroyJoint(joint);
      throw new IllegalStateException(
          "joint="
              + joint
              + " is made on a client; only the server makes joints, in a method that"
              + " runs there alone, such as Game.join or afterStep");
    }
    if (numbers.length < at + STRIDE) {
      numbers = Arrays.copyOf(numbers, Math.max(at + STRIDE, 2 * numbers.length));
    }
    numbers[at + KEY] = isAuthority ? key(joint.index(), joint.generation()) : nextKey;
    numbers[at + ROOT] = announced ? nextRoot : NO_ROOT;
    numbers[at + NUMBER] = announced ? nextNumber : 0;
    if (announced) {
      int[] from = nextDefinition;
      System.arraycopy(from, nextAt, numbers, at + DEFINITION, JointDefRow.INTS);
    } else {
      world.readJoint(joint, numbers, at + DEFINITION);
    }
    changed();
  }

  /** Notes that a joint is about to be destroyed. */
  public void destroyed() {
    changed();
  }

  private void changed() {
    version = ++lastVersion;
  }

  /**
   * Returns a number that changes whenever a joint comes or goes; it is only good for comparison.
   */
  public long version() {
    return version;
  }

  /** Returns a number above the indices of all joints. */
  public int limit() {
    return Math.min(world.jointSlotCount(), numbers.length / STRIDE);
  }

  /** Returns the joint at an index of this world, or null. */
  public Joint<T> get(int index) {
    return world.joint(index);
  }

  /** Returns the key of the joint at an index that is in use. */
  public int key(int index) {
    return numbers[index * STRIDE + KEY];
  }

  /** Returns the id of the root of the assembly of a joint, {@link #NO_ROOT} or {@link #LEVEL}. */
  public int root(int index) {
    return numbers[index * STRIDE + ROOT];
  }

  /** Returns which joint of its assembly, or of the level, a joint is. */
  public int number(int index) {
    return numbers[index * STRIDE + NUMBER];
  }

  /**
   * Copies what a joint was made with.
   *
   * @param to receives {@link JointDefRow#INTS} ints
   * @param at where they begin
   */
  public void definition(int index, int[] to, int at) {
    System.arraycopy(numbers, index * STRIDE + DEFINITION, to, at, JointDefRow.INTS);
  }

  /** Returns an int of what a joint was made with; {@link JointDefRow} declares the fields. */
  public int definition(int index, int field) {
    return numbers[index * STRIDE + DEFINITION + field];
  }

  /**
   * Returns a joint of an assembly or of the level, or null if it is gone. Looks at all joints.
   *
   * @param root the id of the assembly's root, or {@link #LEVEL}
   */
  public Joint<T> find(int root, int number) {
    int limit = limit();
    for (int i = 0, at = 0; i < limit; i++, at += STRIDE) {
      if (numbers[at + ROOT] == root && numbers[at + NUMBER] == number && world.joint(i) != null) {
        return world.joint(i);
      }
    }
    return null;
  }

  /** Mixes what decides the future, and isn't in the world, into a hash. */
  public long hash(long hash) {
    long h = hash;
    if (world.jointCount() > 0) {
      for (int i = 0; i < limit(); i++) {
        if (world.joint(i) != null && root(i) != NO_ROOT) {
          h = StateHash.mix(h, (long) root(i) << 32 | number(i));
        }
      }
    }
    return h;
  }

  /** Copies the table, unless the copy is the same already. */
  public void save(Saved to) {
    if (to.version == version) {
      return;
    }
    to.version = version;
    to.limit = limit();
    if (to.numbers.length < to.limit * STRIDE) {
      to.numbers = new int[numbers.length];
    }
    System.arraycopy(numbers, 0, to.numbers, 0, to.limit * STRIDE);
  }

  /** Takes a copy over, after the world was restored. */
  public void restore(Saved from) {
    int room = Math.max(from.limit, world.jointSlotCount()) * STRIDE;
    if (numbers.length < room) {
      numbers = Arrays.copyOf(numbers, room);
    }
    if (from.version == version) {
      return;
    }
    System.arraycopy(from.numbers, 0, numbers, 0, from.limit * STRIDE);
    if (from.version < 0) {
      changed();
      from.version = version;
    } else {
      version = from.version;
    }
  }
}
