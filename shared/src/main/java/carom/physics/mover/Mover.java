package carom.physics.mover;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.QueryFilter;
import carom.physics.World;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;

/**
 * An upright capsule that its caller moves by a wanted velocity. It walks up and down slopes and
 * steps, slides along walls and ceilings, rides on moving bodies, and pushes dynamic ones.
 *
 * <p><b>Use.</b> Call {@link #move} once per tick, after {@link World#step}, so that the mover
 * stands where the ground is now. Gravity is the caller's:
 *
 * <pre>
 * float vy = mover.isOnGround() ? jumps ? 6 : 0 : mover.velocityY() - 10 * dt;
 * mover.move(walk, vy, dt);
 * </pre>
 *
 * <p><b>On the ground</b> the wanted velocity is relative to the ground. Its part across {@code up}
 * is the speed along the ground, uphill and downhill alike; its part along {@code up} counts only
 * if it is positive: then the mover jumps. A mover that stands keeps its place on what it stands
 * on: it is carried as if it hung on the body, which turns under it.
 *
 * <p><b>In the air</b> the wanted velocity is that of the world. The mover lands where it comes
 * down on ground that isn't too steep. Otherwise it slides.
 *
 * <p><b>What it isn't.</b> The mover is no body: bodies don't collide with it. It gives way to
 * those that come into it, and pushes those in its way with at most {@link MoverDef#pushForce}. If
 * it is caught between two, it {@link #isCrushed}. A game whose bodies must feel it gives it a
 * kinematic body, which the {@link MoverDef#filter} leaves out.
 *
 * <p><b>Exact.</b> A move depends on this state, the world and the arguments alone: it sorts what
 * it finds, and computes with {@code + - * /} and square roots. Moves allocate nothing once they
 * have met as many parts as they will. The state is {@link #INTS} ints.
 *
 * @param <T> the world's user type
 */
public final class Mover<T> {
  /** Number of ints of a mover's state, see {@link #readRow}. */
  public static final int INTS = 11;

  private static final int SLIDES = 8;
  private static final int WALKS = 48;

  /** Number of pieces in which a walk follows the ground, at most; each has a radius or more. */
  private static final int PIECES = 12;

  /** Way below which nothing moves, m. */
  private static final double TINY = 1e-6;

  private static final int GROUND = 1;
  private static final int WALL = 2;
  private static final int CEILING = 4;
  private static final int CRUSHED = 8;
  private static final int ALL_FLAGS = 15;

  private final World<T> world;
  private final Surroundings<T> around;
  private final Planes planes = new Planes();
  private final double radius;
  private final double half;
  private final double skin;
  private final double stepHeight;
  private final double snapDistance;
  private final double maxSlopeCos;
  private final double pushForce;
  private final float weight;
  private final double upX;
  private final double upY;
  private final QueryFilter<T> oneWay;
  private QueryFilter<T> filter;
  private final Aabb area = new Aabb();

  // The state.
  private float x;
  private float y;
  private float vx;
  private float vy;
  private int flags;
  private float groundX;
  private float groundY;
  private int groundBody = -1;
  private int groundGeneration;

  /** Centre of the lower cap in the frame of the ground's body. */
  private float anchorX;

  private float anchorY;

  // The current move: the position relative to where it began, and what it has met.
  private double px;
  private double py;
  private double dt;
  private double slack;
  private double left;
  private double baseX;
  private double baseY;
  private double normalX;
  private double normalY;
  private int groundPart;
  private double budget;
  private Body<T> pushed;

  /**
   * Makes a mover in the air at the origin of the world. Allocates: make one and keep it.
   *
   * @param world the world that it moves in; only its dynamic bodies are changed, by impulses
   * @param def the settings
   */
  public Mover(World<T> world, MoverDef<T> def) {
    this.world = Limits.notNull("world", world);
    around = new Surroundings<>(Limits.notNull("def", def));
    radius = def.radius;
    half = Math.max(0, 0.5 * def.height - def.radius);
    skin = def.skin;
    stepHeight = def.stepHeight;
    snapDistance = def.snapDistance;
    maxSlopeCos = def.maxSlopeCos - 1e-6;
    pushForce = def.pushForce;
    weight = def.weight;
    upX = def.upX;
    upY = def.upY;
    filter = def.filter;
    oneWay = def.oneWay;
  }

  /** Returns x of the capsule's middle, m. */
  public float x() {
    return x;
  }

  /** Returns y of the capsule's middle, m. */
  public float y() {
    return y;
  }

  /** Returns x of the velocity that the last move had, m/s, in the world. */
  public float velocityX() {
    return vx;
  }

  /** Returns y of the velocity that the last move had, m/s, in the world. */
  public float velocityY() {
    return vy;
  }

  /** Returns whether the mover stands or walks on ground that isn't too steep. */
  public boolean isOnGround() {
    return (flags & GROUND) != 0;
  }

  /** Returns whether something at its side stopped the mover in the last move. */
  public boolean isAtWall() {
    return (flags & WALL) != 0;
  }

  /** Returns whether something above it stopped the mover in the last move. */
  public boolean isAtCeiling() {
    return (flags & CEILING) != 0;
  }

  /** Returns whether bodies left the mover no place in the last move, so that it overlaps them. */
  public boolean isCrushed() {
    return (flags & CRUSHED) != 0;
  }

  /** Returns x of the ground's unit normal; 0 in the air. */
  public float groundNormalX() {
    return groundX;
  }

  /** Returns y of the ground's unit normal; 0 in the air. */
  public float groundNormalY() {
    return groundY;
  }

  /** Returns the body that the mover stands on; null in the air, or if it is no more. */
  public Body<T> ground() {
    Body<T> body = groundBody < 0 ? null : world.body(groundBody);
    return body != null && body.generation() == groundGeneration ? body : null;
  }

  /**
   * Sets which shapes are in the mover's way from now on, such as all but the platform through
   * which it drops. It is no part of the state.
   *
   * @param shapes the shapes; null for all but sensors
   */
  public void setFilter(QueryFilter<T> shapes) {
    filter = shapes;
  }

  /**
   * Puts the mover somewhere, in the air and at rest. If it overlaps something there, the next move
   * takes it out.
   *
   * @param newX x of the capsule's middle, m
   * @param newY y of the capsule's middle, m
   */
  public void setPosition(float newX, float newY) {
    Limits.position("x", newX);
    Limits.position("y", newY);
    x = newX;
    y = newY;
    vx = 0;
    vy = 0;
    flags = 0;
    leaveGround();
  }

  /**
   * Looks whether the mover touches ground where it is, and stands on it if so. A game that keeps
   * the mover's place in a body calls this after {@link #setPosition}.
   *
   * @return whether it stands on ground now
   */
  public boolean findGround() {
    world.refuseDuringQuery("findGround");
    dt = 1e-3;
    begin(0, 0, 0, 0);
    groundPart = floor(true);
    if (groundPart >= 0) {
      around.measure(groundPart, px, py);
      land(groundPart);
    }
    end(false);
    return isOnGround();
  }

  /**
   * Moves by a wanted velocity for a time.
   *
   * @param wantedX x of the velocity, m/s; relative to the ground if the mover {@linkplain
   *     #isOnGround stands on it}, otherwise in the world
   * @param wantedY y of the velocity, m/s
   * @param dtSeconds the time, s, more than 0, at most 0.1
   * @throws IllegalStateException during a query
   */
  public void move(float wantedX, float wantedY, float dtSeconds) {
    Limits.velocity("wantedX", wantedX);
    Limits.velocity("wantedY", wantedY);
    dt = Limits.timeStep(dtSeconds);
    world.refuseDuringQuery("move");
    Body<T> ground = isOnGround() ? ground() : null;
    baseX = ground == null ? 0 : velocityAtX(ground, footY(y));
    baseY = ground == null ? 0 : velocityAtY(ground, footX(x));
    double carryX = ground == null ? 0 : carriedX(ground) - footX(x);
    double carryY = ground == null ? 0 : carriedY(ground) - footY(y);
    double rises = wantedX * upX + wantedY * upY;
    double across = wantedX * upY - wantedY * upX;
    boolean walks = isOnGround() && ground != null && !(rises > 0);
    double wx = walks ? across * upY : wantedX + baseX;
    double wy = walks ? -across * upX : wantedY + baseY;

    begin(wx, wy, carryX, carryY);
    slide(carryX, carryY, false);
    if (walks) {
      walk(across);
    } else {
      leaveGround();
      fly(wx, wy);
    }
    end(walks && Math.abs(across) * dt < TINY);
  }

  private double footX(double middle) {
    return middle - half * upX;
  }

  private double footY(double middle) {
    return middle - half * upY;
  }

  /** Returns where the ground's body has the place at which the lower cap was. */
  private double carriedX(Body<T> g) {
    return (double) g.x() + (double) g.cos() * anchorX - (double) g.sin() * anchorY;
  }

  private double carriedY(Body<T> g) {
    return (double) g.y() + (double) g.sin() * anchorX + (double) g.cos() * anchorY;
  }

  private static double velocityAtX(Body<?> body, double atY) {
    return body.velocityX() - (double) body.angularVelocity() * (atY - body.centerY());
  }

  private static double velocityAtY(Body<?> body, double atX) {
    return body.velocityY() + (double) body.angularVelocity() * (atX - body.centerX());
  }

  private void begin(double wx, double wy, double carryX, double carryY) {
    px = 0;
    py = 0;
    slack = Math.max(0.01 * skin, 2.0 * Math.ulp(Math.max(Math.abs(x), Math.abs(y))));
    flags &= GROUND;
    budget = pushForce * dt;
    pushed = null;
    normalX = groundX;
    normalY = groundY;
    groundPart = -1;
    double reach = Math.sqrt(wx * wx + wy * wy) * dt + Math.abs(carryX) + Math.abs(carryY);
    reach += stepHeight + snapDistance + radius + 4 * skin;
    float wide = (float) (Math.abs(half * upX) + radius + reach);
    float high = (float) (Math.abs(half * upY) + radius + reach);
    area.set(x - wide, y - high, x + wide, y + high);
    around.collect(world, area, filter, x, y);
    for (int i = 0; oneWay != null && i < around.count(); i++) {
      if (oneWay.accepts(around.body(i), around.shape(i)) && !isAbove(i)) {
        around.skip(i);
      }
    }
  }

  /** Returns whether the mover was above a one-way part before the part's last motion. */
  private boolean isAbove(int i) {
    Body<T> body = around.body(i);
    if (isOnGround() && body == ground()) {
      return true;
    }
    double above = around.above(i, 0, 0);
    double part = velocityAtX(body, y) * around.faceX + velocityAtY(body, x) * around.faceY;
    return above + Math.max(0, part) * dt >= -skin;
  }

  private void end(boolean stood) {
    double newX = x + px;
    double newY = y + py;
    x = (float) Math.max(-Limits.MAX_POSITION, Math.min(newX, Limits.MAX_POSITION));
    y = (float) Math.max(-Limits.MAX_POSITION, Math.min(newY, Limits.MAX_POSITION));
    if (groundPart >= 0) {
      Body<T> body = around.body(groundPart);
      boolean same = body.index() == groundBody && body.generation() == groundGeneration;
      flags |= GROUND;
      groundX = (float) normalX;
      groundY = (float) normalY;
      groundBody = body.index();
      groundGeneration = body.generation();
      double dx = footX(newX) - body.x();
      double dy = footY(newY) - body.y();
      double wasX = dx - (carriedX(body) - body.x());
      double wasY = dy - (carriedY(body) - body.y());
      // A mover that stands keeps the place it has on the body, so that rounding adds up to
      // nothing.
      if (!(stood && same && wasX * wasX + wasY * wasY < skin * skin)) {
        anchorX = (float) (body.cos() * dx + body.sin() * dy);
        anchorY = (float) (body.cos() * dy - body.sin() * dx);
      }
      if (weight > 0 && body.type() == BodyType.DYNAMIC) {
        body.applyForce(
            (float) (-weight * upX),
            (float) (-weight * upY),
            (float) (footX(newX) - radius * normalX),
            (float) (footY(newY) - radius * normalY));
      }
    } else {
      leaveGround();
    }
    around.clear();
    pushed = null;
  }

  private void leaveGround() {
    flags &= ~GROUND;
    groundX = 0;
    groundY = 0;
    groundBody = -1;
    groundGeneration = 0;
    anchorX = 0;
    anchorY = 0;
    groundPart = -1;
  }

  // ---------------------------------------------------------------- sliding and flying

  /** Moves towards a point that is (dx, dy) away, along what is in the way, and out of overlap. */
  private void slide(double dx, double dy, boolean flies) {
    double goalX = px + dx;
    double goalY = py + dy;
    for (int i = 0; i < SLIDES; i++) {
      boolean any = findPlanes(true, flies);
      planes.solve(goalX - px, goalY - py);
      if (planes.violation > skin) {
        flags |= CRUSHED;
      }
      double wx = planes.x;
      double wy = planes.y;
      if (wx * wx + wy * wy < TINY * TINY) {
        return;
      }
      double fraction = around.cast(px, py, wx, wy, skin, slack);
      px += fraction * wx;
      py += fraction * wy;
      if (around.hit < 0 && !any) {
        return;
      }
    }
  }

  /**
   * Collects the planes of parts that are near.
   *
   * @param gaps true for planes of a way, which may use up gaps; false for those of a velocity
   * @param flies true if slopes that are too steep mustn't lift the mover
   */
  private boolean findPlanes(boolean gaps, boolean flies) {
    boolean any = false;
    planes.clear();
    for (int i = 0; i < around.count(); i++) {
      if (!around.measure(i, px, py) || around.gap > 3 * skin) {
        continue;
      }
      double lacks = skin - around.gap;
      boolean touches = lacks > -4 * slack;
      if (!gaps && !touches) {
        continue;
      }
      any = true;
      double nx = around.normalX;
      double ny = around.normalY;
      double offset = Math.abs(lacks) <= 2 * slack ? 0 : lacks;
      if (!gaps) {
        Body<T> body = around.body(i);
        offset = velocityAtX(body, y + around.pointY) * nx;
        offset += velocityAtY(body, x + around.pointX) * ny;
      }
      planes.add(nx, ny, offset);
      double steep = nx * upX + ny * upY;
      if (flies && touches && steep > 0.01 && steep < maxSlopeCos) {
        double side = nx * upY - ny * upX > 0 ? 1 : -1;
        planes.add(side * upY, -side * upX, 0);
      }
    }
    return any;
  }

  private void fly(double wx, double wy) {
    slide(wx * dt, wy * dt, true);
    meetAll(wx, wy);
    findPlanes(false, true);
    planes.solve(wx, wy);
    vx = speed(planes.x);
    vy = speed(planes.y);
    int part = floor(false);
    if (part >= 0) {
      around.measure(part, px, py);
      Body<T> body = around.body(part);
      double bx = velocityAtX(body, y + around.pointY);
      double by = velocityAtY(body, x + around.pointX);
      double rises = (wx - bx) * around.normalX + (wy - by) * around.normalY;
      if (rises <= 1e-4) {
        land(part);
      }
    }
  }

  private static float speed(double v) {
    return (float) Math.max(-Limits.MAX_VELOCITY, Math.min(v, Limits.MAX_VELOCITY));
  }

  /** Takes the part that was measured last as the ground. */
  private void land(int part) {
    boolean face = around.faceX * upX + around.faceY * upY >= maxSlopeCos;
    groundPart = part;
    normalX = face ? around.faceX : around.normalX;
    normalY = face ? around.faceY : around.normalY;
  }

  /**
   * Returns the nearest part that the mover stands on here, -1 if there is none.
   *
   * @param walks true if corners count by their faces, as they do for a mover that walks
   */
  private int floor(boolean walks) {
    int best = -1;
    double least = skin + 4 * slack;
    for (int i = 0; i < around.count(); i++) {
      if (around.measure(i, px, py) && around.gap <= least && isFloor(walks)) {
        best = i;
        least = around.gap - TINY;
      }
    }
    return best;
  }

  /** Returns whether what was measured last carries a mover. */
  private boolean isFloor(boolean walks) {
    double rises = around.normalX * upX + around.normalY * upY;
    return rises >= maxSlopeCos
        || (walks
            && around.corner
            && rises > 0.01
            && around.faceX * upX + around.faceY * upY >= maxSlopeCos
            && heightOfPoint(px, py) <= stepHeight + slack);
  }

  /** Returns how high the measured point is above the ground of a mover at (atX, atY). */
  private double heightOfPoint(double atX, double atY) {
    return (around.pointX - atX) * upX + (around.pointY - atY) * upY + half + radius + skin;
  }

  /** Meets all parts that it touches and that a velocity leads into. */
  private void meetAll(double wx, double wy) {
    for (int i = 0; i < around.count(); i++) {
      if (around.measure(i, px, py) && around.gap <= skin + 4 * slack) {
        meet(i, wx, wy);
      }
    }
  }

  /** Notes that the part that was measured last stops the mover, and pushes it if it is dynamic. */
  private void meet(int part, double wx, double wy) {
    Body<T> body = around.body(part);
    double nx = around.normalX;
    double ny = around.normalY;
    double bodyX = velocityAtX(body, y + around.pointY);
    double bodyY = velocityAtY(body, x + around.pointX);
    double closing = (bodyX - wx) * nx + (bodyY - wy) * ny;
    if (!(closing > 1e-3)) {
      return;
    }
    double rises = around.normalX * upX + around.normalY * upY;
    if (rises < -0.1) {
      flags |= CEILING;
    } else if (rises < maxSlopeCos) {
      flags |= WALL;
    }
    if (!(budget > 0) || body.type() != BodyType.DYNAMIC || body == pushed) {
      return;
    }
    double rx = x + around.pointX - body.centerX();
    double ry = y + around.pointY - body.centerY();
    double turn = rx * ny - ry * nx;
    double inverse = 1.0 / body.mass();
    inverse += body.inertia() > 0 ? turn * turn / body.inertia() : 0;
    double impulse = Math.min(budget, closing / inverse);
    budget -= impulse;
    pushed = body;
    body.applyImpulse(
        (float) (-impulse * nx),
        (float) (-impulse * ny),
        (float) (x + around.pointX),
        (float) (y + around.pointY));
  }

  // ---------------------------------------------------------------- walking

  /** Walks along the ground, or stands if the speed is 0. */
  private void walk(double across) {
    int under = floor(true);
    if (under >= 0) {
      around.measure(under, px, py);
      land(under);
    }
    double side = across < 0 ? -1 : 1;
    double whole = Math.abs(across) * dt;
    double piece = Math.max(radius, whole / PIECES);
    double walkedX = normalY * side;
    double walkedY = -normalX * side;
    left = whole;
    boolean follows = true;
    for (int i = 0; i < WALKS && left > TINY && follows; i++) {
      double tx = normalY * side;
      double ty = -normalX * side;
      double way = Math.min(left, piece);
      double fraction = around.cast(px, py, tx * way, ty * way, skin, slack);
      int part = around.hit;
      px += tx * way * fraction;
      py += ty * way * fraction;
      left -= way * fraction;
      walkedX = tx;
      walkedY = ty;
      if (part < 0) {
        follows = snap();
      } else if (!turn(part, side, piece, across)) {
        break;
      }
    }
    if (!follows) {
      slide(walkedX * left, walkedY * left, true);
      meetAll(walkedX * Math.abs(across) + baseX, walkedY * Math.abs(across) + baseY);
      left = 0;
    }
    groundPart = -1;
    if (follows) {
      snap();
    }
    double moved = whole > TINY ? (whole - left) / dt : 0;
    vx = speed(walkedX * moved + baseX);
    vy = speed(walkedY * moved + baseY);
  }

  /**
   * Goes on from a part in the way: up the step that it is, or along its slope.
   *
   * @return false if it is a wall
   */
  private boolean turn(int part, double side, double piece, double across) {
    around.measure(part, px, py);
    double nx = around.normalX;
    double ny = around.normalY;
    boolean slope = nx * upX + ny * upY >= maxSlopeCos;
    boolean sharp = around.corner;
    boolean steps = around.body(part).type() != BodyType.DYNAMIC;
    if (steps && (sharp || !slope) && stepUp(side, piece)) {
      return true;
    }
    if (slope) {
      normalX = nx;
      normalY = ny;
      return true;
    }
    around.measure(part, px, py);
    double speed = Math.abs(across);
    meet(part, normalY * side * speed + baseX, -normalX * side * speed + baseY);
    return false;
  }

  /** Tries to go up, forward, and down again onto ground that isn't too high or too steep. */
  private boolean stepUp(double side, double piece) {
    double fromX = px;
    double fromY = py;
    double lift = stepHeight * around.cast(px, py, upX * stepHeight, upY * stepHeight, skin, slack);
    if (!(lift > slack)) {
      return false;
    }
    px += lift * upX;
    py += lift * upY;
    double way = Math.min(left, piece);
    double tx = upY * side;
    double ty = -upX * side;
    double moved = way * around.cast(px, py, tx * way, ty * way, skin, slack);
    px += moved * tx;
    py += moved * ty;
    double down = around.cast(px, py, -lift * upX, -lift * upY, skin, slack);
    int part = around.hit;
    px -= down * lift * upX;
    py -= down * lift * upY;
    boolean lands = moved > Math.min(1e-4, 0.5 * way);
    if (lands && part >= 0) {
      around.measure(part, px, py);
      boolean low = !around.corner || heightOfPoint(fromX, fromY) <= stepHeight + slack;
      lands = low && isFloor(true);
    }
    if (!lands) {
      px = fromX;
      py = fromY;
      return false;
    }
    left -= moved;
    if (part >= 0) {
      land(part);
    }
    return true;
  }

  /**
   * Goes down to the ground.
   *
   * @return false if there is none near enough that isn't too steep; then nothing moves
   */
  private boolean snap() {
    int part = floor(true);
    if (part < 0) {
      double fromX = px;
      double fromY = py;
      double way = around.cast(px, py, -snapDistance * upX, -snapDistance * upY, skin, slack);
      part = around.hit;
      px -= way * snapDistance * upX;
      py -= way * snapDistance * upY;
      if (part < 0 || !around.measure(part, px, py) || !isFloor(true)) {
        px = fromX;
        py = fromY;
        return false;
      }
    } else {
      around.measure(part, px, py);
    }
    land(part);
    return true;
  }

  // ---------------------------------------------------------------- the state

  /**
   * Copies the state, so that {@link #writeRow} gives it back, to the bit. It holds for a world in
   * the state that this one has now.
   *
   * @param row receives {@link #INTS} ints
   * @param at where they begin
   */
  public void readRow(int[] row, int at) {
    Limits.stretch("row", Limits.notNull("row", row).length, at, INTS);
    row[at] = Float.floatToRawIntBits(x);
    row[at + 1] = Float.floatToRawIntBits(y);
    row[at + 2] = Float.floatToRawIntBits(vx);
    row[at + 3] = Float.floatToRawIntBits(vy);
    row[at + 4] = flags;
    row[at + 5] = Float.floatToRawIntBits(groundX);
    row[at + 6] = Float.floatToRawIntBits(groundY);
    row[at + 7] = groundBody;
    row[at + 8] = groundGeneration;
    row[at + 9] = Float.floatToRawIntBits(anchorX);
    row[at + 10] = Float.floatToRawIntBits(anchorY);
  }

  /**
   * Takes over a state. The numbers need not be trusted.
   *
   * @param row {@link #INTS} ints that {@link #readRow} has written
   * @param at where they begin
   * @throws IllegalArgumentException if they are no state of a mover; nothing changes then
   */
  public void writeRow(int[] row, int at) {
    Limits.stretch("row", Limits.notNull("row", row).length, at, INTS);
    float newX = Limits.position("x", Float.intBitsToFloat(row[at]));
    float newY = Limits.position("y", Float.intBitsToFloat(row[at + 1]));
    float newVx = Limits.velocity("velocityX", Float.intBitsToFloat(row[at + 2]));
    float newVy = Limits.velocity("velocityY", Float.intBitsToFloat(row[at + 3]));
    float nx = Limits.range("groundNormalX", Float.intBitsToFloat(row[at + 5]), -1.001f, 1.001f);
    float ny = Limits.range("groundNormalY", Float.intBitsToFloat(row[at + 6]), -1.001f, 1.001f);
    float ax = Limits.coordinate("anchorX", Float.intBitsToFloat(row[at + 9]));
    float ay = Limits.coordinate("anchorY", Float.intBitsToFloat(row[at + 10]));
    boolean grounded = (row[at + 4] & GROUND) != 0;
    boolean unit = Math.abs(nx * nx + ny * ny - (grounded ? 1 : 0)) <= 0.01f;
    if ((row[at + 4] & ~ALL_FLAGS) != 0 || !unit || row[at + 7] < -1) {
      throw new IllegalArgumentException(
          "flags=" + row[at + 4] + " groundBody=" + row[at + 7] + " are no state of a mover");
    }
    x = newX;
    y = newY;
    vx = newVx;
    vy = newVy;
    flags = row[at + 4];
    groundX = nx;
    groundY = ny;
    groundBody = row[at + 7];
    groundGeneration = row[at + 8];
    anchorX = ax;
    anchorY = ay;
  }
}
