package carom.physics;

import carom.physics.broadphase.CastVisitor;
import carom.physics.broadphase.IntVisitor;
import carom.physics.collision.Cast;
import carom.physics.collision.CastHit;
import carom.physics.collision.ClosestPoints;
import carom.physics.collision.Distance;
import carom.physics.dynamics.PartQueries;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;
import java.util.Arrays;

/**
 * Queries about the bodies of a world: casts, overlaps and nearest points. The broadphase's
 * KD-trees find candidates, which are then tested exactly, shape by shape.
 *
 * <p><b>Order.</b> Casts find the nearest hit; of equal fractions they take the body with the
 * smaller index, then its earlier part. "All" methods visit every body once, at its first touch, in
 * this order, until the visitor returns false. Overlaps come by ascending body index. The order
 * never depends on the shape of a tree, so queries may steer a simulation. {@link #parts} visits
 * each convex part.
 *
 * <p><b>Filters.</b> A null filter accepts everything but sensors. A filter that is given decides
 * alone.
 *
 * <p><b>Beginning inside.</b> A cast that begins inside a shape or touching it hits it at fraction
 * 0 with normal (0, 0). Filter out the body that the cast starts from.
 *
 * <p>Queries may be made in collision callbacks, too, but not within another query's filter or
 * visitor. Only one thread may use the object at a time. A query allocates nothing unless its
 * answer is larger than all before. Coordinates are m, world axes.
 *
 * @param <T> the world's user type
 */
public final class Queries<T> {
  private enum Kind {
    RAY,
    SHAPE,
    BOX,
    NEAREST,
    OVERLAP,
    PARTS
  }

  private enum Mode {
    CLOSEST,
    ANY,
    ALL
  }

  /** Factor that ends the search just behind the nearest hit, so that equal fractions are found. */
  private static final float BEHIND = 1.0001f;

  private static final int PART_BITS = BodyStore.PART_BITS;
  private static final int BODY_BITS = BodyStore.SLOT_BITS;
  private static final long NONE = Long.MAX_VALUE;

  private final World<T> world;
  private final Poses poses;
  private final PartQueries parts;
  private final BodyStore store;
  private final Cast cast = new Cast();
  private final Distance distances = new Distance();
  private final CastHit hit = new CastHit();
  private final CastHit partHit = new CastHit();
  private final CastHit bestHit = new CastHit();
  private final ClosestPoints points = new ClosestPoints();
  private final QueryHit<T> found = new QueryHit<>();
  private final Transform pose = new Transform();
  private final Aabb box = new Aabb();
  private final CastVisitor onCast = this::candidate;
  private final IntVisitor onBox = part -> candidate(part, 1) >= 0;

  // The current query.
  private Kind kind = Kind.RAY;
  private Mode mode = Mode.CLOSEST;
  private QueryFilter<T> filter;
  private Shape shape;
  private final Transform start = new Transform();
  private final Aabb startBox = new Aabb();
  private final Aabb search = new Aabb();
  private float dx;
  private float dy;

  // The answer: the best key and fraction, or all keys.
  private long bestKey;
  private float end;
  private long[] keys = new long[16];
  private int keyCount;

  /** Per body slot: the number of the last query that visited it. */
  private int[] visited = new int[0];

  private int question;

  /**
   * Creates the queries of a world.
   *
   * @param poses poses of the bodies; null for those they have now
   */
  Queries(World<T> world, Poses poses) {
    this.world = world;
    this.poses = poses;
    parts = world.dynamics().queries();
    store = world.dynamics().bodies();
  }

  // ---------------------------------------------------------------- rays

  /**
   * Finds the first hit of a ray.
   *
   * @param x x of the start
   * @param y y of the start
   * @param wayX x component of the way from start to end
   * @param wayY y component of the way from start to end
   * @param filter chooses shapes, null for all but sensors
   * @param out receives the hit; unchanged if there is none
   * @return true if the ray hits a shape
   */
  public boolean rayClosest(
      float x, float y, float wayX, float wayY, QueryFilter<T> filter, QueryHit<T> out) {
    Limits.notNull("out", out);
    askRay(Mode.CLOSEST, x, y, wayX, wayY, filter);
    return takeClosest(out);
  }

  /**
   * Returns whether a ray hits anything, which is cheaper than finding the first hit. Parameters
   * are as in {@link #rayClosest}.
   *
   * @return true if the ray hits a shape
   */
  public boolean rayAny(float x, float y, float wayX, float wayY, QueryFilter<T> filter) {
    askRay(Mode.ANY, x, y, wayX, wayY, filter);
    return bestKey != NONE;
  }

  /**
   * Visits every body that a ray hits, from near to far, until the visitor returns false. Other
   * parameters are as in {@link #rayClosest}.
   *
   * @param visitor receives each body once, at the ray's first touch
   */
  public void rayAll(
      float x, float y, float wayX, float wayY, QueryFilter<T> filter, QueryVisitor<T> visitor) {
    Limits.notNull("visitor", visitor);
    askRay(Mode.ALL, x, y, wayX, wayY, filter);
    visitAll(visitor);
  }

  private void askRay(Mode how, float x, float y, float wayX, float wayY, QueryFilter<T> filter) {
    world.refuseDuringQuery("query"); // the question that is asked may not change
    startBox.set(Limits.coordinate("x", x), Limits.coordinate("y", y), x, y);
    castBox(Kind.RAY, how, wayX, wayY, filter);
  }

  // ---------------------------------------------------------------- moving shapes

  /**
   * Finds the first hit of a shape that moves without turning.
   *
   * @param moving the moving shape
   * @param from its pose at the start, read only
   * @param wayX x component of the way from start to end
   * @param wayY y component of the way from start to end
   * @param filter chooses shapes, null for all but sensors
   * @param out receives the hit; unchanged if there is none
   * @return true if the moving shape hits another
   */
  public boolean shapeClosest(
      Shape moving,
      Transform from,
      float wayX,
      float wayY,
      QueryFilter<T> filter,
      QueryHit<T> out) {
    Limits.notNull("out", out);
    askShape(Mode.CLOSEST, moving, from, wayX, wayY, filter);
    return takeClosest(out);
  }

  /**
   * Returns whether a moving shape hits anything. Parameters are as in {@link #shapeClosest}.
   *
   * @return true if the moving shape hits another
   */
  public boolean shapeAny(
      Shape moving, Transform from, float wayX, float wayY, QueryFilter<T> filter) {
    askShape(Mode.ANY, moving, from, wayX, wayY, filter);
    return bestKey != NONE;
  }

  /**
   * Visits every body that a moving shape hits, as if nothing stopped it, from near to far, until
   * the visitor returns false. Other parameters are as in {@link #shapeClosest}.
   *
   * @param visitor receives each body once, at the first touch
   */
  public void shapeAll(
      Shape moving,
      Transform from,
      float wayX,
      float wayY,
      QueryFilter<T> filter,
      QueryVisitor<T> visitor) {
    Limits.notNull("visitor", visitor);
    askShape(Mode.ALL, moving, from, wayX, wayY, filter);
    visitAll(visitor);
  }

  private void askShape(
      Mode how, Shape moving, Transform from, float wayX, float wayY, QueryFilter<T> filter) {
    place(moving, from);
    castBox(Kind.SHAPE, how, wayX, wayY, filter);
  }

  // ---------------------------------------------------------------- moving boxes

  /**
   * Finds the first bounding box that a moving axis-aligned box hits. This is coarser than {@link
   * #shapeClosest}, and cheaper.
   *
   * @param area the box at the start, read only
   * @param wayX x component of the way from start to end
   * @param wayY y component of the way from start to end
   * @param filter chooses shapes, null for all but sensors
   * @param out receives the hit, with the middle of where the boxes touch as its point; unchanged
   *     if there is none
   * @return true if the moving box hits another
   */
  public boolean boxClosest(
      Aabb area, float wayX, float wayY, QueryFilter<T> filter, QueryHit<T> out) {
    Limits.notNull("out", out);
    askBox(Mode.CLOSEST, area, wayX, wayY, filter);
    return takeClosest(out);
  }

  /**
   * Returns whether a moving box hits any bounding box. Parameters are as in {@link #boxClosest}.
   *
   * @return true if the moving box hits another
   */
  public boolean boxAny(Aabb area, float wayX, float wayY, QueryFilter<T> filter) {
    askBox(Mode.ANY, area, wayX, wayY, filter);
    return bestKey != NONE;
  }

  /**
   * Visits every body whose bounding box a moving box hits, from near to far, until the visitor
   * returns false. Other parameters are as in {@link #boxClosest}.
   *
   * @param visitor receives each body once, at the first touch
   */
  public void boxAll(
      Aabb area, float wayX, float wayY, QueryFilter<T> filter, QueryVisitor<T> visitor) {
    Limits.notNull("visitor", visitor);
    askBox(Mode.ALL, area, wayX, wayY, filter);
    visitAll(visitor);
  }

  private void askBox(Mode how, Aabb area, float wayX, float wayY, QueryFilter<T> filter) {
    place(area);
    castBox(Kind.BOX, how, wayX, wayY, filter);
  }

  private void place(Aabb area) {
    world.refuseDuringQuery("query");
    if (Limits.notNull("area", area).isEmpty()) {
      throw new IllegalArgumentException("area=" + area + " is empty, needs min <= max");
    }
    startBox.set(
        Limits.coordinate("minX", area.minX),
        Limits.coordinate("minY", area.minY),
        Limits.coordinate("maxX", area.maxX),
        Limits.coordinate("maxY", area.maxY));
  }

  // ---------------------------------------------------------------- places

  /**
   * Visits the bodies that overlap or touch a shape in a pose.
   *
   * @param area the shape
   * @param at its pose, read only
   * @param filter chooses shapes, null for all but sensors
   * @param visitor receives each body once, by ascending index
   */
  public void overlaps(Shape area, Transform at, QueryFilter<T> filter, QueryVisitor<T> visitor) {
    Limits.notNull("visitor", visitor);
    place(area, at);
    begin(Kind.OVERLAP, Mode.ALL, filter);
    searchBox();
    visitAll(visitor);
  }

  /**
   * Visits the bodies that contain a point, borders included.
   *
   * @param x x of the point
   * @param y y of the point
   * @param filter chooses shapes, null for all but sensors
   * @param visitor receives each body once, by ascending index
   */
  public void containing(float x, float y, QueryFilter<T> filter, QueryVisitor<T> visitor) {
    Limits.notNull("visitor", visitor);
    askPoint(x, y, 0, Mode.ALL, filter);
    visitAll(visitor);
  }

  /**
   * Finds the point of any shape that is nearest to a given point.
   *
   * @param x x of the given point
   * @param y y of the given point
   * @param radius largest distance, 0..1e7
   * @param filter chooses shapes, null for all but sensors
   * @param out receives body, nearest point, distance, and the normal towards the given point;
   *     inside a shape distance and normal are 0; unchanged if nothing is found
   * @return true if a shape is within the radius
   */
  public boolean nearest(float x, float y, float radius, QueryFilter<T> filter, QueryHit<T> out) {
    Limits.notNull("out", out);
    askPoint(x, y, Limits.range("radius", radius, 0, Limits.MAX_COORDINATE), Mode.CLOSEST, filter);
    return takeClosest(out);
  }

  /**
   * Visits the convex parts whose boxes overlap or touch an area, for code that measures for
   * itself, such as a {@link carom.physics.mover.Mover}.
   *
   * @param area the area, read only
   * @param filter chooses shapes, null for all but sensors
   * @param visitor receives each part once, by ascending index of the body, then of the part
   */
  public void parts(Aabb area, QueryFilter<T> filter, PartVisitor<T> visitor) {
    Limits.notNull("visitor", visitor);
    place(area);
    begin(Kind.PARTS, Mode.ALL, filter);
    searchBox();
    Arrays.sort(keys, 0, keyCount);
    world.beginQuery("query");
    try {
      boolean more = true;
      for (int i = 0; i < keyCount && more; i++) {
        int slot = slotOf(keys[i]);
        int part = partOf(keys[i]);
        findPose(slot);
        more = visitor.visit(world.body(slot), parts.shapeOf(part), parts.convexOf(part), pose);
      }
    } finally {
      world.endQuery();
    }
  }

  private void askPoint(float x, float y, float radius, Mode how, QueryFilter<T> filter) {
    world.refuseDuringQuery("query");
    Limits.coordinate("x", x);
    Limits.coordinate("y", y);
    start.set(x, y, 1, 0);
    startBox.set(x, y, x, y).grow(radius);
    begin(Kind.NEAREST, how, filter);
    end = radius;
    searchBox();
  }

  // ---------------------------------------------------------------- how it works

  private void place(Shape moving, Transform from) {
    world.refuseDuringQuery("query");
    Limits.notNull("shape", moving);
    Limits.notNull("pose", from);
    Limits.coordinate("x", from.x);
    Limits.coordinate("y", from.y);
    float square = from.cos * from.cos + from.sin * from.sin;
    if (!(Math.abs(square - 1) <= 0.01f)) {
      throw new IllegalArgumentException(
          "cos=" + from.cos + " sin=" + from.sin + " is no rotation; their squares must add to 1");
    }
    shape = moving;
    start.set(from);
    moving.aabb(from, startBox);
  }

  private void begin(Kind what, Mode how, QueryFilter<T> filter) {
    world.beginQuery("query");
    kind = what;
    mode = how;
    this.filter = filter;
    bestKey = NONE;
    keyCount = 0;
    end = 1;
  }

  private void castBox(Kind what, Mode how, float wayX, float wayY, QueryFilter<T> filter) {
    dx = Limits.coordinate("wayX", wayX);
    dy = Limits.coordinate("wayY", wayY);
    begin(what, how, filter);
    try {
      widen();
      parts.cast(search.minX, search.minY, search.maxX, search.maxY, dx, dy, onCast);
    } finally {
      world.endQuery();
    }
  }

  /** Grows the search box by {@link Poses#reach}, because the trees hold the poses of now. */
  private void widen() {
    search.set(startBox.minX, startBox.minY, startBox.maxX, startBox.maxY);
    if (poses != null) {
      search.grow(poses.reach());
    }
  }

  private void searchBox() {
    try {
      widen();
      parts.query(search.minX, search.minY, search.maxX, search.maxY, onBox);
    } finally {
      world.endQuery();
    }
  }

  /** Tests a part that the trees found, and returns the fraction at which the search ends now. */
  private float candidate(int part, float unused) {
    int slot = parts.bodyOf(part);
    int number = parts.shapeOf(part);
    Body<T> body = world.body(slot);
    boolean seen = filter == null ? !body.sensor(number) : filter.accepts(body, number);
    if (seen && world.sees(body, number) && measure(part, slot)) {
      long key =
          (long) Float.floatToIntBits(hit.fraction) << (BODY_BITS + PART_BITS)
              | (long) slot << PART_BITS
              | (part - store.firstPart[slot]);
      if (mode == Mode.ALL) {
        if (keyCount == keys.length) {
          keys = Arrays.copyOf(keys, keyCount * 2);
        }
        keys[keyCount++] = key;
      } else if (key < bestKey) {
        bestKey = key;
        bestHit.set(hit);
        end = mode == Mode.ANY ? -1 : Math.min(end, hit.fraction * BEHIND);
      }
    }
    return end;
  }

  /** Tests the query against one part and fills {@link #hit}; hits are sorted by its fraction. */
  private boolean measure(int part, int slot) {
    Convex convex = parts.convexOf(part);
    if (!findPose(slot)) {
      return false;
    }
    return switch (kind) {
      case RAY -> cast.ray(convex, pose, startBox.minX, startBox.minY, dx, dy, 1, hit);
      case SHAPE -> measureShape(convex);
      case BOX -> measureBox(part, convex);
      case NEAREST -> measurePoint(convex);
      case OVERLAP -> overlaps(convex);
      case PARTS -> measureArea(part, convex);
    };
  }

  /** Sets {@link #pose} to that of a body's centre of mass, to which its parts are relative. */
  private boolean findPose(int slot) {
    if (poses == null) {
      pose.set(store.x[slot], store.y[slot], store.cos[slot], store.sin[slot]);
      return true;
    }
    if (!poses.place(slot, pose)) {
      return false;
    }
    float x = store.localX[slot];
    float y = store.localY[slot];
    pose.x += pose.cos * x - pose.sin * y;
    pose.y += pose.sin * x + pose.cos * y;
    return true;
  }

  private boolean measureShape(Convex convex) {
    boolean any = false;
    float limit = 1;
    for (int i = 0; i < shape.parts().size(); i++) {
      Convex own = shape.parts().get(i);
      if (cast.shape(own, start, dx, dy, convex, pose, limit, partHit)
          && (!any || partHit.fraction < hit.fraction)) {
        hit.set(partHit);
        limit = hit.fraction;
        any = true;
      }
    }
    return any;
  }

  private boolean measurePoint(Convex convex) {
    hit.fraction = distances.toPoint(convex, pose, start.x, start.y, points);
    hit.x = hit.fraction == 0 ? start.x : pose.x + points.ax;
    hit.y = hit.fraction == 0 ? start.y : pose.y + points.ay;
    hit.normalX = hit.fraction == 0 ? 0 : points.normalX;
    hit.normalY = hit.fraction == 0 ? 0 : points.normalY;
    return hit.fraction <= end;
  }

  private boolean overlaps(Convex convex) {
    for (int i = 0; i < shape.parts().size(); i++) {
      if (distances.between(shape.parts().get(i), start, convex, pose, points) == 0) {
        hit.fraction = 0;
        hit.normalX = 0;
        hit.normalY = 0;
        hit.x = start.x + points.ax;
        hit.y = start.y + points.ay;
        return true;
      }
    }
    return false;
  }

  private boolean measureArea(int part, Convex convex) {
    hit.fraction = 0;
    findBox(part, convex);
    return box.overlaps(startBox);
  }

  private void findBox(int part, Convex convex) {
    if (poses == null) {
      parts.boxOf(part, false, box);
    } else {
      convex.aabb(pose, box);
    }
  }

  /** Sweeps the box through the slabs of both axes; the slab entered last gives the normal. */
  private boolean measureBox(int part, Convex convex) {
    findBox(part, convex);
    double enterX = enter(startBox.minX, startBox.maxX, box.minX, box.maxX, dx);
    double enterY = enter(startBox.minY, startBox.maxY, box.minY, box.maxY, dy);
    double at = Math.max(0, Math.max(enterX, enterY));
    double leaveX = leave(startBox.minX, startBox.maxX, box.minX, box.maxX, dx);
    double leaveY = leave(startBox.minY, startBox.maxY, box.minY, box.maxY, dy);
    if (!(at <= 1 && at <= leaveX && at <= leaveY)) {
      return false;
    }
    boolean inside = enterX <= 0 && enterY <= 0;
    boolean side = enterX >= enterY;
    hit.fraction = (float) at;
    hit.normalX = inside || !side ? 0 : -Math.signum(dx);
    hit.normalY = inside || side ? 0 : -Math.signum(dy);
    hit.x = middle(startBox.minX, startBox.maxX, box.minX, box.maxX, at * dx);
    hit.y = middle(startBox.minY, startBox.maxY, box.minY, box.maxY, at * dy);
    return true;
  }

  private static double enter(double min, double max, double otherMin, double otherMax, double d) {
    if (d == 0) {
      return max >= otherMin && min <= otherMax
          ? Double.NEGATIVE_INFINITY
          : Double.POSITIVE_INFINITY;
    }
    return d > 0 ? (otherMin - max) / d : (otherMax - min) / d;
  }

  private static double leave(double min, double max, double otherMin, double otherMax, double d) {
    if (d == 0) {
      return Double.POSITIVE_INFINITY;
    }
    return d > 0 ? (otherMax - min) / d : (otherMin - max) / d;
  }

  private static float middle(double min, double max, double otherMin, double otherMax, double d) {
    return (float) (0.5 * (Math.max(min + d, otherMin) + Math.min(max + d, otherMax)));
  }

  private boolean takeClosest(QueryHit<T> out) {
    if (bestKey == NONE) {
      return false;
    }
    fill(bestKey, bestHit, out);
    return true;
  }

  private static int slotOf(long key) {
    return (int) (key >>> PART_BITS) & ((1 << BODY_BITS) - 1);
  }

  private int partOf(long key) {
    return store.firstPart[slotOf(key)] + ((int) key & ((1 << PART_BITS) - 1));
  }

  private void fill(long key, CastHit from, QueryHit<T> out) {
    int slot = slotOf(key);
    int part = partOf(key);
    boolean moves = kind == Kind.RAY || kind == Kind.SHAPE || kind == Kind.BOX;
    float way = (float) Math.sqrt((double) dx * dx + (double) dy * dy);
    out.set(
        world.body(slot),
        parts.shapeOf(part),
        moves ? from.fraction : 0,
        moves ? from.fraction * way : from.fraction,
        from);
  }

  /** Passes all hits to the visitor, in order, each body once. */
  private void visitAll(QueryVisitor<T> visitor) {
    if (visited.length < store.slots()) {
      visited = new int[Math.max(store.slots(), visited.length * 2)];
      question = 0;
    }
    question++;
    Arrays.sort(keys, 0, keyCount);
    world.beginQuery("query");
    try {
      for (int i = 0; i < keyCount; i++) {
        int slot = slotOf(keys[i]);
        if (visited[slot] == question) {
          continue;
        }
        visited[slot] = question;
        measure(partOf(keys[i]), slot);
        fill(keys[i], hit, found);
        if (!visitor.visit(found)) {
          return;
        }
      }
    } finally {
      world.endQuery();
    }
  }
}
