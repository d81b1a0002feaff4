package carom.physics.dynamics.body;

import carom.physics.broadphase.AabbArray;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.settings.Settings;
import java.util.Arrays;

/**
 * The convex parts of all bodies' shapes, with their materials and their boxes in the broadphase.
 *
 * <p>The parts of one body are neighbours; freed blocks wait in a list per size until a body with
 * as many parts comes. Part numbers and boxes never influence a result, so they are no part of the
 * state hash.
 *
 * <p>A <b>fat box</b> contains the part's tight box with a margin, so that it stays valid for some
 * ticks and the broadphase has nothing to do for quiet bodies.
 */
public final class ShapeTable {
  /** Number of values of {@link #kind}. */
  public static final int KINDS = 4;

  private static final int FIRST_CAPACITY = 64;

  /** The part, relative to its body's centre of mass. */
  public Convex[] convex = new Convex[FIRST_CAPACITY];

  /** The kind of each part: 0 a disc, 1 a box, 2 another sharp polygon, 3 anything else. */
  public byte[] kind = new byte[FIRST_CAPACITY];

  /** Floats per part in {@link #box}. */
  public static final int BOX = 4;

  /** The half width, half height and centre x, y of each box in its body's frame, m. */
  public float[] box = new float[BOX * FIRST_CAPACITY];

  /** The body that owns it, -1 if free. */
  public int[] body = new int[FIRST_CAPACITY];

  /** The number of the shape, as the user gave them, that each part belongs to. */
  public int[] shapeIndex = new int[FIRST_CAPACITY];

  /** The Coulomb coefficient of each part. */
  public float[] friction = new float[FIRST_CAPACITY];

  /** The restitution of each part, 0..1. */
  public float[] restitution = new float[FIRST_CAPACITY];

  /** The rolling resistance of each part, as a fraction of its radius. */
  public float[] rolling = new float[FIRST_CAPACITY];

  /** The speed of each part's surface, m/s. */
  public float[] tangentSpeed = new float[FIRST_CAPACITY];

  /**
   * The rules that mix friction and restitution of parts, with those that parts have for
   * themselves.
   */
  public final MaterialMixing mixing;

  /** The part's category; see {@code carom.physics.Filter}. */
  int[] category = new int[FIRST_CAPACITY];

  int[] mask = new int[FIRST_CAPACITY];
  int[] group = new int[FIRST_CAPACITY];

  /** True if the part is a sensor, by part. */
  public boolean[] sensor = new boolean[FIRST_CAPACITY];

  /** True once a part was a sensor or had a filter. Until then, pairs are not filtered. */
  private boolean selective;

  /** True once a part was a sensor. Until then, no stage looks for sensors. */
  private boolean sensors;

  /** True if the box changed since pairs were last searched, by part. */
  public boolean[] moved = new boolean[FIRST_CAPACITY];

  /**
   * True if the box changed together with those of most neighbours, which are searched as one, by
   * part.
   */
  public boolean[] together = new boolean[FIRST_CAPACITY];

  /** True if the part is queued for insertion into a tree, by part. */
  public boolean[] pending = new boolean[FIRST_CAPACITY];

  /** The boxes in the broadphase; never restored, only widened when they no longer contain. */
  public final AabbArray fat = new AabbArray(FIRST_CAPACITY);

  /**
   * The boxes themselves, at the poses when boxes were last refreshed, with half the speculative
   * distance around: parts whose boxes are apart have no contact.
   */
  public final AabbArray tight = new AabbArray(FIRST_CAPACITY);

  /** Per block size: the first free block's part, -1 if none; the next one is in {@link #body}. */
  private final int[] freeBlocks = new int[BodyStore.MAX_PARTS + 1];

  private final ShapePool pool = new ShapePool();
  private int[] nextFree = new int[FIRST_CAPACITY];
  private int used;

  /**
   * Makes an empty table.
   *
   * @param settings has the world's rules of mixing materials
   */
  public ShapeTable(Settings settings) {
    mixing = new MaterialMixing(settings, FIRST_CAPACITY);
    Arrays.fill(freeBlocks, -1);
  }

  /** Returns one more than the largest part ever used. */
  public int used() {
    return used;
  }

  /**
   * Decides whether two filters let their parts meet; the same either way round.
   *
   * @param categoryA what A is
   * @param maskA what A meets
   * @param groupA A's group
   * @param categoryB what B is
   * @param maskB what B meets
   * @param groupB B's group
   * @return whether A and B meet
   */
  public static boolean meet(
      int categoryA, int maskA, int groupA, int categoryB, int maskB, int groupB) {
    if (groupA == groupB && groupA != 0) {
      return groupA > 0;
    }
    return (maskA & categoryB) != 0 && (maskB & categoryA) != 0;
  }

  /** Returns whether the filters of two parts let them meet, and not both are sensors. */
  public boolean meet(int p, int q) {
    return !selective
        || (!(sensor[p] && sensor[q])
            && meet(category[p], mask[p], group[p], category[q], mask[q], group[q]));
  }

  /** Returns whether any part is a sensor, or was one. */
  public boolean anySensors() {
    return sensors;
  }

  /** Fills a part in. */
  void set(int part, Convex local, int shape, ShapeSpec spec) {
    convex[part] = pool.share(local);
    kind[part] = kind(local);
    if (local instanceof Box b) {
      box[BOX * part] = b.halfWidth();
      box[BOX * part + 1] = b.halfHeight();
      box[BOX * part + 2] = b.centerX();
      box[BOX * part + 3] = b.centerY();
    }
    shapeIndex[part] = shape;
    friction[part] = spec.friction();
    restitution[part] = spec.restitution();
    rolling[part] = spec.rollingResistance();
    tangentSpeed[part] = spec.tangentSpeed();
    mixing.set(part, spec.frictionMixing(), spec.restitutionMixing());
    category[part] = spec.category();
    mask[part] = spec.mask();
    group[part] = spec.group();
    sensor[part] = spec.sensor();
    selective |= !spec.plain();
    sensors |= spec.sensor();
  }

  private static byte kind(Convex part) {
    if (!part.isSimple()) {
      return 3;
    }
    return (byte) (part instanceof Circle ? 0 : part instanceof Box ? 1 : 2);
  }

  /** Returns whether a part is a disc. */
  public boolean isDisc(int part) {
    return kind[part] == 0;
  }

  /** Returns whether a part is a box. */
  public boolean isBox(int part) {
    return kind[part] == 1;
  }

  /** Returns whether a part is a box or another polygon with sharp corners. */
  public boolean isPolygon(int part) {
    return kind[part] == 1 || kind[part] == 2;
  }

  /** Takes a block of parts for a body; returns the first. */
  int allocate(int owner, int parts) {
    if (parts == 0) {
      return 0;
    }
    int first = freeBlocks[parts];
    if (first >= 0) {
      freeBlocks[parts] = nextFree[first];
    } else {
      first = used;
      used += parts;
      ensure(used);
    }
    for (int p = first; p < first + parts; p++) {
      body[p] = owner;
      moved[p] = false;
      together[p] = false;
    }
    return first;
  }

  /** Gives a block of parts back. */
  public void release(int first, int parts) {
    if (parts == 0) {
      return;
    }
    for (int p = first; p < first + parts; p++) {
      body[p] = -1;
      convex[p] = null;
      moved[p] = false;
      together[p] = false;
    }
    nextFree[first] = freeBlocks[parts];
    freeBlocks[parts] = first;
  }

  /** Copies everything but boxes into another table, which grows as needed. */
  public void copyTo(ShapeTable to) {
    to.ensure(used);
    System.arraycopy(convex, 0, to.convex, 0, used);
    System.arraycopy(kind, 0, to.kind, 0, used);
    System.arraycopy(box, 0, to.box, 0, BOX * used);
    if (to.used > used) {
      Arrays.fill(to.convex, used, to.used, null);
      Arrays.fill(to.body, used, to.used, -1);
    }
    System.arraycopy(body, 0, to.body, 0, used);
    System.arraycopy(shapeIndex, 0, to.shapeIndex, 0, used);
    System.arraycopy(friction, 0, to.friction, 0, used);
    System.arraycopy(restitution, 0, to.restitution, 0, used);
    System.arraycopy(rolling, 0, to.rolling, 0, used);
    System.arraycopy(tangentSpeed, 0, to.tangentSpeed, 0, used);
    mixing.copyTo(to.mixing, used);
    System.arraycopy(category, 0, to.category, 0, used);
    System.arraycopy(mask, 0, to.mask, 0, used);
    System.arraycopy(group, 0, to.group, 0, used);
    System.arraycopy(sensor, 0, to.sensor, 0, used);
    to.selective |= selective;
    to.sensors |= sensors;
    System.arraycopy(nextFree, 0, to.nextFree, 0, used);
    System.arraycopy(freeBlocks, 0, to.freeBlocks, 0, freeBlocks.length);
    Arrays.fill(to.moved, false);
    Arrays.fill(to.together, false);
    to.used = used;
  }

  private void ensure(int capacity) {
    if (capacity > body.length) {
      int grown = Math.max(capacity, body.length * 2);
      convex = Arrays.copyOf(convex, grown);
      kind = Arrays.copyOf(kind, grown);
      box = Arrays.copyOf(box, BOX * grown);
      body = Arrays.copyOf(body, grown);
      shapeIndex = Arrays.copyOf(shapeIndex, grown);
      friction = Arrays.copyOf(friction, grown);
      restitution = Arrays.copyOf(restitution, grown);
      rolling = Arrays.copyOf(rolling, grown);
      tangentSpeed = Arrays.copyOf(tangentSpeed, grown);
      mixing.grow(grown);
      category = Arrays.copyOf(category, grown);
      mask = Arrays.copyOf(mask, grown);
      group = Arrays.copyOf(group, grown);
      sensor = Arrays.copyOf(sensor, grown);
      moved = Arrays.copyOf(moved, grown);
      together = Arrays.copyOf(together, grown);
      pending = Arrays.copyOf(pending, grown);
      nextFree = Arrays.copyOf(nextFree, grown);
    }
    fat.ensureCapacity(body.length);
    tight.ensureCapacity(body.length);
  }
}
